"""The report in a real browser: pages load without a network, formulas and figures are drawn, links and search work."""

import shutil

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
pytestmark = pytest.mark.skipif(
    not (CHROMIUM and DRIVER), reason="needs Debian's chromium and chromium-driver, which .ci/run installs where it can"
)
FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-component-update",
    "--disable-background-networking", "--disable-sync", "--window-size=390,844",
)  # fmt: skip


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(flag)
    driver = webdriver.Chrome(options, webdriver.ChromeService(DRIVER))
    yield driver
    driver.quit()


def test_clicking_through_the_report(browser, report):
    browser.get((report / "index.html").as_uri())
    pages = [a.get_attribute("href") for a in browser.find_elements(By.CSS_SELECTOR, "nav a")]
    assert len(pages) >= 4
    for page in pages:
        browser.get(page)
        assert browser.find_element(By.TAG_NAME, "h1").text
        wide = browser.execute_script("return document.documentElement.scrollWidth - window.innerWidth")
        assert wide <= 0, f"{page} is wider than a phone by {wide} pixels"


def test_formulas_and_figures_are_drawn(browser, report):
    browser.get((report / "smith2012.html").as_uri())
    heights = [f.size["height"] for f in browser.find_elements(By.TAG_NAME, "math")]
    assert len(heights) > 100
    assert min(heights) > 5
    fraction = browser.find_element(By.CSS_SELECTOR, "math mfrac").size["height"]
    assert fraction > 18  # two storeys: the browser lays MathML out, it does not print its text in a row
    figures = browser.find_elements(By.CSS_SELECTOR, "figure svg")
    assert figures
    assert all(f.size["height"] > 100 for f in figures)


def test_a_statement_is_found_and_opened(browser, report):
    browser.get((report / "index.html").as_uri())
    browser.find_element(By.ID, "search").send_keys("62b")
    rows = [r for r in browser.find_elements(By.CSS_SELECTOR, ".statements tr td:first-child a") if r.is_displayed()]
    assert [r.text for r in rows] == ["smith2012:62b"]
    rows[0].click()
    assert browser.current_url.endswith("smith2012.html#smith2012:62b")
    assert "misprint" in browser.find_element(By.ID, "smith2012:62b").text
