(* A motion beside the true one (derivation defect-bound, docs/theory/certificates.md): for x'' + k x + f = 0 and
   y'' + k y + g = r with |r| <= rho, f a value of F at x' and g one at y', and F monotone, the distance E, with
   E^2 = k (x - y)^2 + (x' - y')^2, grows by rho (t - s) at most.  F is a relation: dry friction is in it, F(0) = [-H, H].
   The equations need not hold at finitely many times: where the mass turns or stops its velocity has a corner. *)
From Coq Require Import Reals Lra Psatz List.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Section DefectBound.
Variables (k rho : R) (F : R -> R -> Prop) (f g r x v y w : R -> R).
Hypothesis kpos : 0 < k.
Hypothesis Fmon : forall u s u' s', F u s -> F u' s' -> 0 <= (s - s') * (u - u').

Definition square t := k * (x t - y t) ^ 2 + (v t - w t) ^ 2.
Definition E t := sqrt (square t).

Lemma square_pos t : 0 <= square t.
Proof. unfold square. pose proof (pow2_ge_0 (x t - y t)). pose proof (pow2_ge_0 (v t - w t)). nra. Qed.

Lemma speed_le t : Rabs (v t - w t) <= E t.
Proof.
  unfold E. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold square, Rsqr.
  pose proof (pow2_ge_0 (x t - y t)). nra.
Qed.

Lemma place_le t : sqrt k * Rabs (x t - y t) <= E t.
Proof.
  unfold E. rewrite <- (sqrt_Rsqr_abs (x t - y t)), <- sqrt_mult_alt by lra. apply sqrt_le_1_alt. unfold square, Rsqr.
  pose proof (pow2_ge_0 (v t - w t)). nra.
Qed.

(* The equations at the time t: the true motion with the force f, the other one with g and the defect r. *)
Definition moves t :=
  is_derive x t (v t) /\ is_derive v t (- k * x t - f t) /\ F (v t) (f t) /\
  is_derive y t (w t) /\ is_derive w t (r t - k * y t - g t) /\ F (w t) (g t) /\ Rabs (r t) <= rho.

Definition goes_on t := continuity_pt x t /\ continuity_pt v t /\ continuity_pt y t /\ continuity_pt w t.

Lemma square_rate t : moves t -> is_derive square t (-2 * (f t - g t + r t) * (v t - w t)).
Proof.
  intros (hx & hv & _ & hy & hw & _ & _). unfold square. evar_last.
  - apply (is_derive_plus (fun t => k * (x t - y t) ^ 2) (fun t => (v t - w t) ^ 2)).
    + apply (is_derive_scal (fun t => (x t - y t) ^ 2)), (is_derive_pow (fun t => x t - y t) 2), (is_derive_minus x y);
        [exact hx | exact hy].
    + apply (is_derive_pow (fun t => v t - w t) 2), (is_derive_minus v w); [exact hv | exact hw].
  - unfold scal, plus, minus, opp; simpl. unfold mult, plus; simpl. ring.
Qed.

(* Away from 0 the root is differentiable; a small d > 0 under it keeps it so everywhere. *)
Definition Ed d t := sqrt (square t + d).

Lemma Ed_rate d t : 0 < d -> moves t -> exists e, is_derive (Ed d) t e /\ e <= rho.
Proof.
  intros hd ht.
  assert (hpos : 0 < square t + d) by (pose proof (square_pos t); lra).
  exists ((-2 * (f t - g t + r t) * (v t - w t)) / (2 * sqrt (square t + d))). split.
  - unfold Ed. evar_last.
    + apply (is_derive_comp sqrt (fun t => square t + d)).
      * apply is_derive_Reals, derivable_pt_lim_sqrt. exact hpos.
      * apply (is_derive_plus square (fun _ => d)); [apply square_rate, ht | apply is_derive_const].
    + unfold scal, plus, zero; simpl. unfold mult, plus, zero; simpl. field.
      pose proof (sqrt_lt_R0 _ hpos). lra.
  - destruct ht as (_ & _ & hf & _ & _ & hg & hb).
    assert (hs : 0 < sqrt (square t + d)) by (apply sqrt_lt_R0; exact hpos).
    apply (Rmult_le_reg_r (2 * sqrt (square t + d))); [lra |].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (hE : Rabs (v t - w t) <= sqrt (square t + d)).
    { apply Rle_trans with (1 := speed_le t). unfold E. apply sqrt_le_1_alt. lra. }
    pose proof (Fmon _ _ _ _ hf hg) as hm.
    assert (hp : - (r t * (v t - w t)) <= rho * sqrt (square t + d)).
    { apply Rle_trans with (Rabs (r t) * Rabs (v t - w t)).
      - rewrite <- Rabs_mult, <- Rabs_Ropp. apply Rle_abs.
      - apply Rmult_le_compat; try apply Rabs_pos; assumption. }
    nra.
Qed.

Lemma Ed_goes_on d t : 0 < d -> goes_on t -> continuity_pt (Ed d) t.
Proof.
  intros hd (hx & hv & hy & hw).
  apply (continuity_pt_comp (fun t => square t + d) sqrt).
  - apply (continuity_pt_plus square (fun _ => d)); [| apply continuity_pt_const; intros ? ?; reflexivity].
    apply (continuity_pt_plus (fun t => k * (x t - y t) ^ 2) (fun t => (v t - w t) ^ 2)).
    + apply (continuity_pt_scal (fun t => (x t - y t) ^ 2)).
      apply (continuity_pt_comp (fun t => x t - y t) (fun u => u ^ 2)); [now apply continuity_pt_minus |].
      apply derivable_continuous_pt, derivable_pt_pow.
    + apply (continuity_pt_comp (fun t => v t - w t) (fun u => u ^ 2)); [now apply continuity_pt_minus |].
      apply derivable_continuous_pt, derivable_pt_pow.
  - apply continuity_pt_sqrt. pose proof (square_pos t). lra.
Qed.

(* The rate inside the interval; at its ends, where there need be none, rho. *)
Definition rate d a b t := if Rlt_dec a t then if Rlt_dec t b then Derive (Ed d) t else rho else rho.

Lemma close d a b : 0 < d -> a <= b -> (forall t, a < t < b -> moves t) -> (forall t, a <= t <= b -> goes_on t) ->
  Ed d b <= Ed d a + rho * (b - a).
Proof.
  intros hd hab hm hc. destruct (Req_dec a b) as [<- | hne]; [lra |].
  destruct (MVT_gen (Ed d) a b (rate d a b)) as (c & _ & he).
  - intros t ht. rewrite Rmin_left, Rmax_right in ht by lra. unfold rate.
    destruct (Rlt_dec a t); [| lra]. destruct (Rlt_dec t b); [| lra].
    destruct (Ed_rate d t hd (hm t ht)) as (e & h & _). apply Derive_correct. now exists e.
  - intros t ht. rewrite Rmin_left, Rmax_right in ht by lra. apply Ed_goes_on; [exact hd | apply hc, ht].
  - assert (rate d a b c <= rho).
    { unfold rate. destruct (Rlt_dec a c); [| lra]. destruct (Rlt_dec c b); [| lra].
      destruct (Ed_rate d c hd (hm c ltac:(lra))) as (e & h & hle). now rewrite (is_derive_unique _ _ _ h). }
    nra.
Qed.

Lemma between a b : a <= b -> (forall t, a < t < b -> moves t) -> (forall t, a <= t <= b -> goes_on t) ->
  E b <= E a + rho * (b - a).
Proof.
  intros hab hm hc. apply le_epsilon. intros eps heps.
  pose proof (close (eps ^ 2) a b ltac:(nra) hab hm hc) as h. unfold Ed in h.
  assert (hb : E b <= sqrt (square b + eps ^ 2)) by (apply sqrt_le_1_alt; nra).
  assert (ha : sqrt (square a + eps ^ 2) <= E a + eps).
  { unfold E. rewrite <- (sqrt_pow2 (sqrt (square a) + eps)).
    - apply sqrt_le_1_alt. pose proof (sqrt_sqrt _ (square_pos a)). pose proof (sqrt_pos (square a)). nra.
    - pose proof (sqrt_pos (square a)). lra. }
  lra.
Qed.

(* The equations hold but at the times of a list. *)
Theorem defect_bound corners : forall a b, a <= b ->
  (forall t, a < t < b -> ~ In t corners -> moves t) -> (forall t, a <= t <= b -> goes_on t) ->
  E b <= E a + rho * (b - a).
Proof.
  induction corners as [| c rest IH]; intros a b hab hm hc.
  - apply between; try assumption. intros t ht. apply hm; [exact ht | intros []].
  - assert (at_most : forall t, a < t < b -> t <> c -> ~ In t rest -> moves t).
    { intros t ht hne hnot. apply hm; [exact ht |]. intros [he | hin]; [now apply hne | now apply hnot]. }
    destruct (Rlt_dec a c) as [hac | hac]; [destruct (Rlt_dec c b) as [hcb | hcb] |].
    + assert (first : E c <= E a + rho * (c - a)).
      { apply IH; [lra | intros t ht; apply at_most; lra | intros t ht; apply hc; lra]. }
      assert (second : E b <= E c + rho * (b - c)).
      { apply IH; [lra | intros t ht; apply at_most; lra | intros t ht; apply hc; lra]. }
      lra.
    + apply IH; [exact hab | intros t ht; apply at_most; lra | exact hc].
    + apply IH; [exact hab | intros t ht; apply at_most; lra | exact hc].
Qed.
End DefectBound.

(* What F may be: nondecreasing with dry friction H, that is F(u) + H beyond 0, F(u) - H before it, [-H, H] at 0. *)
Definition with_friction (F : R -> R) H u s :=
  (0 < u -> s = F u + H) /\ (u < 0 -> s = F u - H) /\ (u = 0 -> - H <= s <= H).

Lemma friction_is_monotone (F : R -> R) H : 0 <= H -> F 0 = 0 -> (forall u u', u <= u' -> F u <= F u') ->
  forall u s u' s', with_friction F H u s -> with_friction F H u' s' -> 0 <= (s - s') * (u - u').
Proof.
  intros hH h0 hF.
  assert (ordered : forall u s u' s', with_friction F H u s -> with_friction F H u' s' -> u < u' -> s <= s').
  { intros u s u' s' (p & n & z) (p' & n' & z') hlt. pose proof (hF u u' ltac:(lra)).
    destruct (Rtotal_order u 0) as [hu | [hu | hu]], (Rtotal_order u' 0) as [hu' | [hu' | hu']]; try lra;
      repeat match goal with
      | h : ?a < 0, q : ?a < 0 -> _ |- _ => specialize (q h)
      | h : ?a > 0, q : 0 < ?a -> _ |- _ => specialize (q h)
      | h : ?a = 0, q : ?a = 0 -> _ |- _ => specialize (q h)
      end; subst; try rewrite h0 in *; lra. }
  intros u s u' s' h h'. destruct (Rtotal_order u u') as [hlt | [he | hgt]].
  - pose proof (ordered _ _ _ _ h h' hlt). nra.
  - subst. nra.
  - pose proof (ordered _ _ _ _ h' h hgt). nra.
Qed.

Print Assumptions defect_bound.
Print Assumptions friction_is_monotone.
