(* A turning point beside a rest of an approximant (derivation landing).  At the time T the true speed is e at most, the
   place is no nearer to the centre than c > 0, and the mass moves outwards: it rests, within e/(k c) in time, and while
   it is on that side of the centre it rests once only.  Without dry friction: F(0) = 0. *)
From Coq Require Import Reals Ranalysis5 Lra Psatz Classical.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* The first zero of what begins positive. *)
Lemma first_zero (f : R -> R) a b : a <= b -> (forall t, a <= t <= b -> continuity_pt f t) -> 0 < f a -> f b <= 0 ->
  exists z, a < z <= b /\ f z = 0 /\ forall t, a <= t < z -> 0 < f t.
Proof.
  intros hab hf ha hb.
  pose (S t := a <= t <= b /\ forall s, a <= s <= t -> 0 < f s).
  assert (inS : S a). { split; [lra |]. intros s hs. replace s with a by lra. exact ha. }
  destruct (completeness S) as (z & up & least).
  - exists b. intros t (ht & _). lra.
  - now exists a.
  - assert (az : a <= z) by (apply up, inS).
    assert (zb : z <= b) by (apply least; intros t (ht & _); lra).
    assert (before : forall t, a <= t < z -> 0 < f t).
    { intros t ht. apply NNPP. intros hn.
      assert (z <= t); [| lra]. apply least. intros s (hs & pos).
      destruct (Rle_lt_dec s t) as [h | h]; [exact h |]. exfalso. apply hn, pos. lra. }
    destruct (Rtotal_order (f z) 0) as [neg | [zero | pos]].
    + (* It would be negative a little before. *)
      exfalso. destruct (Req_dec a z) as [<- | hne]; [lra |].
      destruct (hf z ltac:(lra) (- f z) ltac:(lra)) as (d & hd & near).
      pose (t := Rmax a (z - d / 2)).
      assert (ht : a <= t < z) by (unfold t, Rmax; destruct (Rle_dec a (z - d / 2)); lra).
      specialize (near t). assert (Rabs (f t - f z) < - f z) as hc.
      { apply near. split; [split; [exact I | lra] |]. simpl. unfold R_dist. rewrite Rabs_left by lra.
        unfold t, Rmax. destruct (Rle_dec a (z - d / 2)); lra. }
      pose proof (before t ht). pose proof (Rle_abs (f t - f z)). lra.
    + exists z. split; [| split; assumption]. split; [| exact zb].
      destruct (Req_dec a z) as [<- | hne]; lra.
    + (* It would go on. *)
      exfalso. destruct (Req_dec z b) as [-> | hne]; [lra |].
      destruct (hf z ltac:(lra) (f z) pos) as (d & hd & near).
      pose (t := Rmin b (z + d / 2)).
      assert (ht : z < t <= b /\ t - z <= d / 2) by (unfold t, Rmin; destruct (Rle_dec b (z + d / 2)); lra).
      assert (S t) as inside; [| apply up in inside; lra]. split; [lra |]. intros s hs.
      destruct (Rle_lt_dec z s) as [h | h]; [| apply before; lra].
      destruct (Req_dec z s) as [<- | hne']; [exact pos |].
      specialize (near s). assert (Rabs (f s - f z) < f z) as hc.
      { apply near. split; [split; [exact I | lra] |]. simpl. unfold R_dist. rewrite Rabs_right by lra. lra. }
      pose proof (Rle_abs (- (f s - f z))) as hr. rewrite Rabs_Ropp in hr. lra.
Qed.

Section Landing.
Variables (k e c T : R) (F x v : R -> R).
Hypothesis kpos : 0 < k.
Hypothesis cpos : 0 < c.
Hypothesis Fpos : forall u, 0 <= u -> 0 <= F u.
Hypothesis hx : forall t, T <= t -> is_derive x t (v t).
Hypothesis hv : forall t, T <= t -> is_derive v t (- k * x t - F (v t)).
Hypothesis far : c <= x T.
Hypothesis slow : 0 <= v T <= e.

Let late := e / (k * c).

Lemma late_pos : 0 <= late.
Proof. apply Rmult_le_pos; [lra |]. left. apply Rinv_0_lt_compat. nra. Qed.

Lemma continuous_v t : T <= t -> continuity_pt v t.
Proof.
  intros ht. apply continuity_pt_filterlim, (ex_derive_continuous v). eexists. apply hv, ht.
Qed.

(* As long as it moves outwards it is no nearer to the centre. *)
Lemma outwards t : T <= t -> (forall s, T <= s <= t -> 0 <= v s) -> x T <= x t.
Proof.
  intros ht moving. destruct (MVT_gen x T t v) as (s & hs & h).
  - intros s hs. rewrite Rmin_left, Rmax_right in hs by lra. apply hx. lra.
  - intros s hs. rewrite Rmin_left, Rmax_right in hs by lra.
    apply continuity_pt_filterlim, (ex_derive_continuous x). eexists. apply hx. lra.
  - rewrite Rmin_left, Rmax_right in hs by lra. pose proof (moving s hs). nra.
Qed.

Lemma it_stops : exists t, T <= t <= T + late /\ v t <= 0.
Proof.
  apply NNPP. intros none.
  assert (moving : forall s, T <= s <= T + late -> 0 < v s).
  { intros s hs. apply Rnot_le_lt. intros h. apply none. exists s. split; assumption. }
  pose proof late_pos as hl.
  destruct (MVT_gen v T (T + late) (fun t => - k * x t - F (v t))) as (s & hs & h).
  - intros s hs. rewrite Rmin_left, Rmax_right in hs by lra. apply hv. lra.
  - intros s hs. rewrite Rmin_left, Rmax_right in hs by lra. apply continuous_v. lra.
  - rewrite Rmin_left, Rmax_right in hs by lra.
    assert (hc : c <= x s).
    { apply Rle_trans with (1 := far). apply outwards; [lra |]. intros s' hs'. left. apply moving. lra. }
    pose proof (Fpos (v s) (Rlt_le _ _ (moving s hs))) as hF.
    pose proof (moving (T + late) ltac:(lra)) as hend.
    assert (k * c * late = e) by (unfold late; field; nra).
    assert (k * c <= k * x s) by nra.
    nra.
Qed.

(* It rests, when and where. *)
Theorem landing : exists z, T <= z <= T + late /\ v z = 0 /\ (forall t, T <= t < z -> 0 < v t) /\
  x T <= x z <= x T + e * late.
Proof.
  destruct (Rle_lt_or_eq_dec 0 (v T) (proj1 slow)) as [pos | zero].
  - destruct it_stops as (b & hb & hvb).
    destruct (first_zero v T b) as (z & hz & hvz & moving); try lra.
    { intros t ht. apply continuous_v. lra. }
    exists z. repeat split; try lra; try assumption.
    + apply outwards; [lra |]. intros s hs. destruct (Req_dec s z) as [-> | hne]; [lra |]. left. apply moving. lra.
    + (* On the way the speed falls. *)
      assert (slower : forall t, T <= t <= z -> v t <= e).
      { intros t ht. destruct (MVT_gen v T t (fun t => - k * x t - F (v t))) as (s & hs & h).
        - intros s hs. rewrite Rmin_left, Rmax_right in hs by lra. apply hv. lra.
        - intros s hs. rewrite Rmin_left, Rmax_right in hs by lra. apply continuous_v. lra.
        - rewrite Rmin_left, Rmax_right in hs by lra.
          assert (forall s', T <= s' <= s -> 0 <= v s').
          { intros s' hs'. destruct (Req_dec s' z) as [-> | hne]; [lra |]. left. apply moving. lra. }
          pose proof (outwards s ltac:(lra) H). pose proof (Fpos (v s) (H s ltac:(lra))).
          assert (0 <= k * x s) by nra. nra. }
      destruct (MVT_gen x T z v) as (s & hs & h).
      * intros s hs. rewrite Rmin_left, Rmax_right in hs by lra. apply hx. lra.
      * intros s hs. rewrite Rmin_left, Rmax_right in hs by lra.
        apply continuity_pt_filterlim, (ex_derive_continuous x). eexists. apply hx. lra.
      * rewrite Rmin_left, Rmax_right in hs by lra. pose proof (slower s hs). pose proof late_pos. nra.
  - exists T. pose proof late_pos. repeat split; try lra. intros t ht. lra. nra.
Qed.
End Landing.

(* It rests once: where x > 0 the speed falls through its zeros, so between two of them the place would have a least
   value, at a rest from which it moves inwards. *)
Section Once.
Variables (k a b : R) (F x v : R -> R).
Hypothesis kpos : 0 < k.
Hypothesis F0 : F 0 = 0.
Hypothesis hx : forall t, a <= t <= b -> is_derive x t (v t).
Hypothesis hv : forall t, a <= t <= b -> is_derive v t (- k * x t - F (v t)).
Hypothesis side : forall t, a <= t <= b -> 0 < x t.

Lemma falls z : a <= z <= b -> v z = 0 ->
  exists d, 0 < d /\ forall t, a <= t <= b -> Rabs (t - z) < d -> (z < t -> v t < 0) /\ (t < z -> 0 < v t).
Proof.
  intros hz hvz. pose proof (hv z hz) as h. rewrite hvz, F0, Rminus_0_r in h. apply is_derive_Reals in h.
  pose proof (side z hz) as hs. destruct (h (k * x z / 2) ltac:(nra)) as (d & near).
  exists d. split; [apply cond_pos |]. intros t ht hd.
  assert (below : t <> z -> (v t - v z) / (t - z) < 0).
  { intros hne. specialize (near (t - z) ltac:(lra) hd). replace (z + (t - z)) with t in near by ring.
    pose proof (Rle_abs ((v t - v z) / (t - z) - - k * x z)). nra. }
  rewrite hvz, Rminus_0_r in below. split; intros hlt.
  - specialize (below ltac:(lra)). apply Rnot_le_lt. intros hn.
    assert (0 <= v t / (t - z)); [| lra]. apply Rmult_le_pos; [exact hn |]. left. apply Rinv_0_lt_compat. lra.
  - specialize (below ltac:(lra)). apply Rnot_le_lt. intros hn.
    assert (0 <= v t / (t - z)); [| lra]. replace (v t / (t - z)) with (- v t / (z - t)) by (field; lra).
    apply Rmult_le_pos; [lra |]. left. apply Rinv_0_lt_compat. lra.
Qed.

Lemma moves_inwards z : a <= z <= b -> v z = 0 -> z < b -> exists t, z < t < b /\ x t < x z.
Proof.
  intros hz hvz hzb. destruct (falls z hz hvz) as (d & hd & near).
  pose (t := z + Rmin d (b - z) / 2).
  assert (ht : z < t < b /\ t - z < d).
  { unfold t, Rmin. destruct (Rle_dec d (b - z)); lra. }
  exists t. split; [lra |].
  destruct (MVT_cor2 x v z t ltac:(lra)) as (s & h & hs).
  - intros s hs. apply is_derive_Reals, hx. lra.
  - assert (v s < 0). { apply (near s); [lra | | lra]. rewrite Rabs_right by lra. lra. }
    nra.
Qed.

Lemma comes_outwards z : a <= z <= b -> v z = 0 -> a < z -> exists t, a < t < z /\ x t < x z.
Proof.
  intros hz hvz haz. destruct (falls z hz hvz) as (d & hd & near).
  pose (t := z - Rmin d (z - a) / 2).
  assert (ht : a < t < z /\ z - t < d).
  { unfold t, Rmin. destruct (Rle_dec d (z - a)); lra. }
  exists t. split; [lra |].
  destruct (MVT_cor2 x v t z ltac:(lra)) as (s & h & hs).
  - intros s hs. apply is_derive_Reals, hx. lra.
  - assert (0 < v s). { apply (near s); [lra | | lra]. rewrite Rabs_left by lra. lra. }
    nra.
Qed.
End Once.

Theorem rests_once k a b F x v : 0 < k -> F 0 = 0 ->
  (forall t, a <= t <= b -> is_derive x t (v t)) -> (forall t, a <= t <= b -> is_derive v t (- k * x t - F (v t))) ->
  (forall t, a <= t <= b -> 0 < x t) ->
  forall y z, a <= y <= b -> a <= z <= b -> v y = 0 -> v z = 0 -> y = z.
Proof.
  intros kpos F0 hx hv side.
  assert (wlog : forall y z, a <= y -> z <= b -> v y = 0 -> v z = 0 -> ~ y < z).
  { intros y z ha hb hy hz hlt.
    destruct (continuity_ab_min x y z ltac:(lra)) as (m & least & hm).
    { intros t ht. apply continuity_pt_filterlim, (ex_derive_continuous x). eexists. apply hx. lra. }
    assert (within : forall t, y <= t <= z -> a <= t <= b) by (intros; lra).
    assert (hx' : forall t, y <= t <= z -> is_derive x t (v t)) by (intros; apply hx; lra).
    assert (hv' : forall t, y <= t <= z -> is_derive v t (- k * x t - F (v t))) by (intros; apply hv; lra).
    assert (side' : forall t, y <= t <= z -> 0 < x t) by (intros; apply side; lra).
    destruct (moves_inwards k y z F x v kpos F0 hx' hv' side' y ltac:(lra) hy hlt) as (t1 & ht1 & h1).
    destruct (comes_outwards k y z F x v kpos F0 hx' hv' side' z ltac:(lra) hz hlt) as (t2 & ht2 & h2).
    pose proof (least t1 ltac:(lra)) as l1. pose proof (least t2 ltac:(lra)) as l2.
    assert (inside : y < m < z).
    { split; apply Rnot_le_lt; intros hn.
      - replace m with y in l1 by lra. lra.
      - replace m with z in l2 by lra. lra. }
    assert (hvm : v m = 0).
    { assert (pr : derivable_pt x m) by (exists (v m); apply is_derive_Reals, hx; lra).
      rewrite <- (deriv_minimum x y z m pr (proj1 inside) (proj2 inside)) by (intros; apply least; lra).
      symmetry. apply derive_pt_eq_0, is_derive_Reals, hx. lra. }
    destruct (moves_inwards k y z F x v kpos F0 hx' hv' side' m ltac:(lra) hvm (proj2 inside)) as (t & ht & h).
    pose proof (least t ltac:(lra)). lra. }
  intros y z hy hz hvy hvz. destruct (Rtotal_order y z) as [h | [h | h]]; [| exact h |]; exfalso.
  - now apply (wlog y z).
  - now apply (wlog z y).
Qed.

Print Assumptions landing.
Print Assumptions rests_once.
