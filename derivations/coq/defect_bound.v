(* A motion beside the true one (derivation defect-bound, docs/theory/certificates.md): for x'' + k x + F(x') = 0 with F
   nondecreasing and y'' + k y + F(y') = r with |r| <= rho, the distance E, E^2 = k (x - y)^2 + (x' - y')^2, grows by
   rho (t - s) at most.  Differentiable motions: this is every law without dry friction.  With dry friction the velocities
   are absolutely continuous, and the same inequality holds almost everywhere: that case is on the page, not here. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Section DefectBound.
Variables (k rho : R) (F r x v y w : R -> R) (a b : R).
Hypothesis kpos : 0 < k.
Hypothesis rhopos : 0 <= rho.
Hypothesis Fmon : forall u u', u <= u' -> F u <= F u'.
Hypothesis hx : forall t, a <= t <= b -> is_derive x t (v t).
Hypothesis hy : forall t, a <= t <= b -> is_derive y t (w t).
Hypothesis hv : forall t, a <= t <= b -> is_derive v t (- k * x t - F (v t)).
Hypothesis hw : forall t, a <= t <= b -> is_derive w t (r t - k * y t - F (w t)).
Hypothesis hr : forall t, a <= t <= b -> Rabs (r t) <= rho.

Definition square t := k * (x t - y t) ^ 2 + (v t - w t) ^ 2.
Definition E t := sqrt (square t).

Lemma square_pos t : 0 <= square t.
Proof. unfold square. pose proof (pow2_ge_0 (x t - y t)). pose proof (pow2_ge_0 (v t - w t)). nra. Qed.

Lemma square_rate t : a <= t <= b ->
  is_derive square t (-2 * (F (v t) - F (w t) + r t) * (v t - w t)).
Proof.
  intros ht. unfold square. evar_last.
  - apply (is_derive_plus (fun t => k * (x t - y t) ^ 2) (fun t => (v t - w t) ^ 2)).
    + apply (is_derive_scal (fun t => (x t - y t) ^ 2)), (is_derive_pow (fun t => x t - y t) 2), (is_derive_minus x y);
        [apply hx | apply hy]; exact ht.
    + apply (is_derive_pow (fun t => v t - w t) 2), (is_derive_minus v w); [apply hv | apply hw]; exact ht.
  - unfold scal, plus, minus, opp; simpl. unfold mult, plus; simpl. ring.
Qed.

Lemma monotone u u' : 0 <= (F u - F u') * (u - u').
Proof.
  destruct (Rle_dec u u') as [h | h].
  - pose proof (Fmon _ _ h). nra.
  - assert (h' : u' <= u) by lra. pose proof (Fmon _ _ h'). nra.
Qed.

Lemma speed_le t : Rabs (v t - w t) <= E t.
Proof.
  unfold E. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold square, Rsqr.
  pose proof (pow2_ge_0 (x t - y t)). nra.
Qed.

(* Away from 0 the root is differentiable; a small d > 0 under it keeps it so everywhere. *)
Definition Ed d t := sqrt (square t + d).

Lemma Ed_rate d t : 0 < d -> a <= t <= b ->
  exists e, is_derive (Ed d) t e /\ e <= rho.
Proof.
  intros hd ht.
  assert (hpos : 0 < square t + d) by (pose proof (square_pos t); lra).
  exists ((-2 * (F (v t) - F (w t) + r t) * (v t - w t)) / (2 * sqrt (square t + d))). split.
  - unfold Ed. evar_last.
    + apply (is_derive_comp sqrt (fun t => square t + d)).
      * apply is_derive_Reals, derivable_pt_lim_sqrt. exact hpos.
      * apply (is_derive_plus square (fun _ => d)); [apply square_rate, ht | apply is_derive_const].
    + unfold scal, plus, zero; simpl. unfold mult, plus, zero; simpl. field.
      pose proof (sqrt_lt_R0 _ hpos). lra.
  - assert (hs : 0 < sqrt (square t + d)) by (apply sqrt_lt_R0; exact hpos).
    apply (Rmult_le_reg_r (2 * sqrt (square t + d))); [lra |].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (hE : Rabs (v t - w t) <= sqrt (square t + d)).
    { apply Rle_trans with (1 := speed_le t). unfold E. apply sqrt_le_1_alt. lra. }
    pose proof (monotone (v t) (w t)) as hm. pose proof (hr t ht) as hb.
    assert (hp : - (r t * (v t - w t)) <= rho * sqrt (square t + d)).
    { apply Rle_trans with (Rabs (r t) * Rabs (v t - w t)).
      - rewrite <- Rabs_mult, <- Rabs_Ropp. apply Rle_abs.
      - apply Rmult_le_compat; try apply Rabs_pos; assumption. }
    nra.
Qed.

Theorem defect_bound : a <= b -> E b <= E a + rho * (b - a).
Proof.
  intros hab.
  assert (close : forall d, 0 < d -> Ed d b <= Ed d a + rho * (b - a)).
  { intros d hd. destruct (Req_dec a b) as [<- | hne]; [lra |].
    destruct (MVT_gen (Ed d) a b (Derive (Ed d))) as (c & hc & he).
    - intros t ht. rewrite Rmin_left, Rmax_right in ht by lra.
      destruct (Ed_rate d t hd) as (e & h & _); [lra |]. apply Derive_correct. now exists e.
    - intros t ht. rewrite Rmin_left, Rmax_right in ht by lra.
      destruct (Ed_rate d t hd) as (e & h & _); [lra |].
      apply continuity_pt_filterlim, (ex_derive_continuous (Ed d)). now exists e.
    - rewrite Rmin_left, Rmax_right in hc by lra.
      destruct (Ed_rate d c hd hc) as (e & h & hle).
      rewrite (is_derive_unique _ _ _ h) in he. nra. }
  apply le_epsilon. intros eps heps.
  pose proof (close (eps ^ 2) ltac:(nra)) as hc. unfold Ed in hc.
  assert (hb : E b <= sqrt (square b + eps ^ 2)) by (apply sqrt_le_1_alt; nra).
  assert (ha : sqrt (square a + eps ^ 2) <= E a + eps).
  { unfold E. rewrite <- (sqrt_pow2 (sqrt (square a) + eps)).
    - apply sqrt_le_1_alt. pose proof (sqrt_sqrt _ (square_pos a)). pose proof (sqrt_pos (square a)). nra.
    - pose proof (sqrt_pos (square a)). lra. }
  lra.
Qed.

Lemma place_le t : sqrt k * Rabs (x t - y t) <= E t.
Proof.
  unfold E. rewrite <- (sqrt_Rsqr_abs (x t - y t)), <- sqrt_mult_alt by lra. apply sqrt_le_1_alt. unfold square, Rsqr.
  pose proof (pow2_ge_0 (v t - w t)). nra.
Qed.
End DefectBound.
Print Assumptions defect_bound.
