"""Certificates: a motion by polynomials, with claims on it that ``testing.check_certificate`` proves without us."""
