(* A turning point beside a rest of an approximant (derivation landing): at the time T the true speed is e at most, the
   place is no nearer to the centre than c > 0, and the mass moves outwards.  Without dry friction. *)
From Coq Require Import Reals Ranalysis5 Lra Psatz Classical.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Section Landing.
Variables (k e c T : R) (F x v : R -> R).
Hypothesis kpos : 0 < k.
Hypothesis cpos : 0 < c.
Hypothesis epos : 0 <= e.
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
Lemma outwards t : T <= t -> (forall s, T <= s <= t -> 0 < v s) -> c <= x t.
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
    assert (hc : c <= x s) by (apply outwards; [lra | intros s' hs'; apply moving; lra]).
    pose proof (Fpos (v s) (Rlt_le _ _ (moving s hs))) as hF.
    pose proof (moving (T + late) ltac:(lra)) as hend.
    assert (k * c * late = e) by (unfold late; field; nra).
    assert (k * c <= k * x s) by nra.
    nra.
Qed.

Theorem landing : exists t, T <= t <= T + late /\ v t = 0.
Proof.
  destruct it_stops as (t & ht & hvt).
  destruct (Rle_lt_or_eq_dec 0 (v T) (proj1 slow)) as [hpos | hzero].
  - destruct (Rle_lt_or_eq_dec (v t) 0 hvt) as [hneg | heq]; [| exists t; split; [lra | exact heq]].
    destruct (Rle_lt_or_eq_dec T t (proj1 ht)) as [hlt | heq]; [| subst t; lra].
    destruct (IVT_interv (fun s => - v s) T t) as (z & hz & h).
    + intros s hs. apply continuity_pt_opp, continuous_v. lra.
    + exact hlt.
    + lra.
    + lra.
    + exists z. split; [lra | lra].
  - exists T. pose proof late_pos. split; [lra | now symmetry].
Qed.
End Landing.
Print Assumptions landing.
