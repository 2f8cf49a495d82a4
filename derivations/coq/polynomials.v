(* Polynomials with integer coefficients, lowest first, and how large they are for |u| <= 1. *)
From Coq Require Import Reals ZArith List Lra Psatz.
From Coquelicot Require Import Coquelicot.
Import ListNotations.
Open Scope R_scope.

Fixpoint value (p : list Z) (u : R) : R := match p with [] => 0 | a :: q => IZR a + u * value q u end.
Fixpoint value_at (p : list Z) (u : Z) : Z := match p with [] => 0 | a :: q => a + u * value_at q u end%Z.
Fixpoint add (p q : list Z) : list Z :=
  match p, q with [], _ => q | _, [] => p | a :: p', b :: q' => (a + b)%Z :: add p' q' end.
Definition scale (c : Z) (p : list Z) : list Z := map (Z.mul c) p.
Fixpoint mul (p q : list Z) : list Z := match p with [] => [] | a :: p' => add (scale a q) (0%Z :: mul p' q) end.
Fixpoint diff (p : list Z) : list Z := match p with [] => [] | _ :: q => add q (0%Z :: diff q) end.
Fixpoint norm (p : list Z) : Z := match p with [] => 0 | a :: q => Z.abs a + norm q end%Z.

Lemma value_at_value p u : value p (IZR u) = IZR (value_at p u).
Proof. induction p as [| a p IH]; simpl; [reflexivity |]. now rewrite IH, plus_IZR, mult_IZR. Qed.

Lemma value_add p : forall q u, value (add p q) u = value p u + value q u.
Proof.
  induction p as [| a p IH]; intros q u; simpl; [lra |].
  destruct q as [| b q]; simpl; [lra |]. rewrite IH, plus_IZR. ring.
Qed.

Lemma value_scale c p u : value (scale c p) u = IZR c * value p u.
Proof. induction p as [| a p IH]; simpl; [ring |]. rewrite IH, mult_IZR. ring. Qed.

Lemma value_mul p q u : value (mul p q) u = value p u * value q u.
Proof. induction p as [| a p IH]; simpl; [ring |]. rewrite value_add, value_scale. simpl. rewrite IH. ring. Qed.

Lemma derive_value p u : is_derive (value p) u (value (diff p) u).
Proof.
  induction p as [| a p IH]; simpl; [apply (is_derive_const (V := R_NormedModule) 0) |].
  rewrite value_add. simpl. evar_last.
  - apply (is_derive_plus (fun _ => IZR a) (fun t => t * value p t)); [apply is_derive_const |].
    apply (is_derive_mult (fun t => t) (value p)); [apply is_derive_id | exact IH | intros; apply Rmult_comm].
  - unfold plus, zero, one; simpl. unfold mult; simpl. ring.
Qed.

Lemma value_le_norm p u : Rabs u <= 1 -> Rabs (value p u) <= IZR (norm p).
Proof.
  intros hu. induction p as [| a p IH]; simpl; [rewrite Rabs_R0; lra |].
  rewrite plus_IZR, abs_IZR. apply Rle_trans with (1 := Rabs_triang _ _). apply Rplus_le_compat_l.
  rewrite Rabs_mult. pose proof (Rabs_pos (value p u)). nra.
Qed.

(* How far a polynomial is from its first coefficient. *)
Lemma value_near_first a p u : Rabs u <= 1 -> IZR (a - norm p) <= value (a :: p) u <= IZR (a + norm p).
Proof.
  intros hu. simpl. rewrite minus_IZR, plus_IZR. pose proof (value_le_norm p u hu) as h.
  assert (Rabs (u * value p u) <= IZR (norm p)) as h'.
  { rewrite Rabs_mult. pose proof (Rabs_pos (value p u)). nra. }
  pose proof (Rle_abs (u * value p u)). pose proof (Rle_abs (- (u * value p u))) as h2. rewrite Rabs_Ropp in h2. lra.
Qed.

Print Assumptions value_near_first.
