(* One half-swing of x'' + x + x'^3/10 = 0 beside the polynomials of a certificate: what its checker does for this law,
   proved.  A piece is (P, s), P its coefficients over 2^bits and s its scale, u = (t - c)/s: c where u = 0, s < 0 for
   the piece that arrives. *)
From Coq Require Import Reals ZArith QArith Qreals List Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import defect_bound landing polynomials.
Import ListNotations.
Open Scope R_scope.

Definition cubic (u : R) := u ^ 3 / 10.

Lemma cubic_is_monotone u s u' s' : s = cubic u -> s' = cubic u' -> 0 <= (s - s') * (u - u').
Proof.
  intros -> ->. unfold cubic. replace ((u ^ 3 / 10 - u' ^ 3 / 10) * (u - u')) with
    ((u - u') ^ 2 * ((u + u' / 2) ^ 2 + 3 / 4 * u' ^ 2) / 10) by field.
  pose proof (pow2_ge_0 (u - u')). pose proof (pow2_ge_0 (u + u' / 2)). pose proof (pow2_ge_0 u'). nra.
Qed.

Lemma jump a b c d : sqrt ((a + b) ^ 2 + (c + d) ^ 2) <= sqrt (a ^ 2 + c ^ 2) + Rabs b + Rabs d.
Proof.
  pose proof (pow2_ge_0 a) as ha. pose proof (pow2_ge_0 c) as hc.
  assert (h0 : 0 <= a ^ 2 + c ^ 2) by lra.
  pose proof (sqrt_pos (a ^ 2 + c ^ 2)) as hA. pose proof (sqrt_sqrt _ h0) as hA2. set (A := sqrt (a ^ 2 + c ^ 2)) in *.
  pose proof (Rabs_pos b) as hb. pose proof (Rabs_pos d) as hd.
  rewrite <- (sqrt_pow2 (A + Rabs b + Rabs d)) by lra. apply sqrt_le_1_alt.
  assert (a <= A /\ - a <= A /\ c <= A /\ - c <= A) as (? & ? & ? & ?) by (repeat split; nra).
  assert (a * b <= A * Rabs b) by (unfold Rabs; destruct (Rcase_abs b); nra).
  assert (c * d <= A * Rabs d) by (unfold Rabs; destruct (Rcase_abs d); nra).
  pose proof (pow2_abs b). pose proof (pow2_abs d). nra.
Qed.

Section HalfSwing.
Variable M : positive.  (* 2^bits *)
Let m := IZR (Zpos M).

Variables x v : R -> R.
Hypothesis hx : forall t, 0 <= t -> is_derive x t (v t).
Hypothesis hv : forall t, 0 <= t -> is_derive v t (- x t - cubic (v t)).

Definition near t (Y W e : Q) := sqrt (1 * (x t - Q2R Y) ^ 2 + (v t - Q2R W) ^ 2) <= Q2R e.

(* What a piece is at a whole u, and its defect, (10 M^2 n d^2 P'' + 10 M^2 n^3 P + d^3 P'^3)/(10 M^3 n^3), s = n/d. *)
Definition place (p : list Z) (u : Z) : Q := value_at p u # M.
Definition speed (p : list Z) (s : Q) (u : Z) : Q := (value_at (diff p) u # M) / s.
Definition defect (p : list Z) (s : Q) : list Z :=
  let n := Qnum s in let d := Zpos (Qden s) in let one := Zpos M in
  add (scale (10 * one * one * n * d * d) (diff (diff p)))
    (add (scale (10 * one * one * n * n * n) p) (scale (d * d * d) (mul (diff p) (mul (diff p) (diff p))))).
Definition rho (p : list Z) (s : Q) : Q :=
  inject_Z (norm (defect p s)) / inject_Z (10 * Zpos M * Zpos M * Zpos M * Z.abs (Qnum s * Qnum s * Qnum s)).
Definition size (q : Q) : Q := Z.abs (Qnum q) # Qden q.

Lemma m_pos : 0 < m.
Proof. apply (IZR_lt 0). reflexivity. Qed.

Lemma Q2R_whole z : Q2R (inject_Z z) = IZR z.
Proof. unfold Q2R, inject_Z; simpl. lra. Qed.

Lemma size_is_Rabs q : Q2R (size q) = Rabs (Q2R q).
Proof.
  unfold size, Q2R; simpl. rewrite abs_IZR, Rabs_mult. f_equal. symmetry. apply Rabs_right.
  left. apply Rinv_0_lt_compat, (IZR_lt 0). reflexivity.
Qed.

Lemma Q2R_place p u : Q2R (place p u) = value p (IZR u) / m.
Proof. now rewrite value_at_value. Qed.

Lemma Q2R_speed p s u : ~ s == 0 -> Q2R (speed p s u) = value (diff p) (IZR u) / (m * Q2R s).
Proof.
  intros hs. unfold speed. rewrite Q2R_div by exact hs. rewrite value_at_value. unfold Q2R at 1; simpl. fold m.
  pose proof m_pos. assert (Q2R s <> 0). { intros h. apply hs, eqR_Qeq. rewrite h. unfold Q2R; simpl. lra. }
  field. lra.
Qed.

Section Piece.
Variables (p : list Z) (s : Q) (c : R).
Hypothesis snot0 : ~ s == 0.
Let S := Q2R s.
Let y t := value p ((t - c) / S) / m.
Let w t := value (diff p) ((t - c) / S) / (m * S).
Let r t := value (diff (diff p)) ((t - c) / S) / (m * S * S) + y t + cubic (w t).

Lemma S_not0 : S <> 0.
Proof. intros h. apply snot0, eqR_Qeq. fold S. rewrite h. unfold Q2R; simpl. lra. Qed.

Lemma derive_y t : is_derive y t (w t).
Proof.
  pose proof m_pos. pose proof S_not0. unfold y, w. evar_last.
  - apply (is_derive_ext (fun t => scal (/ m) (value p ((t - c) / S)))).
    { intros t'. unfold scal; simpl. unfold mult; simpl. field. lra. }
    apply (is_derive_scal (fun t => value p ((t - c) / S))).
    apply (is_derive_comp (value p) (fun t => (t - c) / S)); [apply derive_value |].
    apply (is_derive_ext (fun t => scal (/ S) (t - c))).
    { intros t'. unfold scal; simpl. unfold mult; simpl. field. assumption. }
    apply (is_derive_scal (fun t => t - c)), (is_derive_minus (fun t => t) (fun _ => c));
      [apply is_derive_id | apply is_derive_const].
  - unfold scal, minus, plus, opp, one, zero; simpl. unfold mult; simpl. field. split; lra.
Qed.

Lemma derive_w t : is_derive w t (r t - 1 * y t - cubic (w t)).
Proof.
  pose proof m_pos. pose proof S_not0. unfold r. evar_last.
  - unfold w. apply (is_derive_ext (fun t => scal (/ (m * S)) (value (diff p) ((t - c) / S)))).
    { intros t'. unfold scal; simpl. unfold mult; simpl. field. split; lra. }
    apply (is_derive_scal (fun t => value (diff p) ((t - c) / S))).
    apply (is_derive_comp (value (diff p)) (fun t => (t - c) / S)); [apply derive_value |].
    apply (is_derive_ext (fun t => scal (/ S) (t - c))).
    { intros t'. unfold scal; simpl. unfold mult; simpl. field. assumption. }
    apply (is_derive_scal (fun t => t - c)), (is_derive_minus (fun t => t) (fun _ => c));
      [apply is_derive_id | apply is_derive_const].
  - unfold scal, minus, plus, opp, one, zero; simpl. unfold mult; simpl. field. split; lra.
Qed.

Lemma num_not0 : Qnum s <> 0%Z.
Proof. intros h. apply snot0. unfold Qeq. rewrite h. reflexivity. Qed.

Lemma defect_small t : Rabs ((t - c) / S) <= 1 -> Rabs (r t) <= Q2R (rho p s).
Proof.
  intros hu. pose proof m_pos as hm. pose proof S_not0 as hS. pose proof num_not0 as hz.
  pose (n := IZR (Qnum s)). pose (d := IZR (Zpos (Qden s))).
  assert (hd : 0 < d) by (apply (IZR_lt 0); reflexivity).
  assert (hSnd : S = n / d) by reflexivity.
  assert (hn : n <> 0) by (apply not_0_IZR; exact hz).
  assert (hn3 : n * n * n <> 0).
  { intros h. apply Rmult_integral in h.
    destruct h as [h |]; [apply Rmult_integral in h; destruct h |]; contradiction. }
  assert (hm3 : 0 < 10 * m * m * m) by (repeat apply Rmult_lt_0_compat; lra).
  replace (r t) with (value (defect p s) ((t - c) / S) / (10 * m * m * m * (n * n * n))).
  - unfold Rdiv. rewrite Rabs_mult, Rabs_inv.
    unfold rho. rewrite Q2R_div.
    + rewrite !Q2R_whole, !mult_IZR, abs_IZR, !mult_IZR. fold m n.
      rewrite Rabs_mult, (Rabs_right (10 * m * m * m)) by lra.
      apply Rmult_le_compat_r; [| apply value_le_norm, hu].
      left. apply Rinv_0_lt_compat, Rmult_lt_0_compat; [exact hm3 | apply Rabs_pos_lt, hn3].
    + unfold Qeq, inject_Z. cbn [Qnum Qden]. lia.
  - unfold r, y, w, cubic, defect. rewrite !value_add, !value_scale, !value_mul, !mult_IZR. fold m n d.
    rewrite hSnd. field. repeat split; lra.
Qed.

Variables (u0 u1 : Z) (t0 : R) (Y W e : Q).
Hypothesis ends : (Z.abs u0 <= 1 /\ Z.abs u1 <= 1)%Z.
Hypothesis begins : c = t0 - S * IZR u0.
Hypothesis later : 0 <= t0.
Hypothesis forward : (0 <= s * inject_Z (u1 - u0))%Q.
Hypothesis near0 : near t0 Y W e.

Definition lasts : Q := s * inject_Z (u1 - u0).
Definition after : Q := e + size (place p u0 - Y) + size (speed p s u0 - W) + rho p s * lasts.

Lemma lasts_S : Q2R lasts = S * (IZR u1 - IZR u0).
Proof. unfold lasts. now rewrite Q2R_mult, Q2R_whole, minus_IZR. Qed.

Lemma lasts_pos : 0 <= Q2R lasts.
Proof.
  apply Qle_Rle in forward. fold lasts in forward. replace 0 with (Q2R 0) by (unfold Q2R; simpl; lra). exact forward.
Qed.

Lemma within t : t0 <= t <= t0 + Q2R lasts -> Rabs ((t - c) / S) <= 1.
Proof.
  intros ht. pose proof S_not0 as hS. rewrite lasts_S in ht.
  assert (he : -1 <= IZR u0 <= 1 /\ -1 <= IZR u1 <= 1).
  { destruct ends as (h0 & h1). repeat split; apply IZR_le; lia. }
  pose (q := (t - t0) / S). assert (hq : S * q = t - t0) by (unfold q; field; exact hS).
  replace ((t - c) / S) with (IZR u0 + q) by (unfold q; rewrite begins; field; exact hS).
  apply Rabs_le. destruct (Rtotal_order S 0) as [neg | [zero | pos]]; [| contradiction |].
  - assert (IZR u1 - IZR u0 <= q <= 0) by (split; nra). lra.
  - assert (0 <= q <= IZR u1 - IZR u0) by (split; nra). lra.
Qed.

Lemma rho_pos : 0 <= Q2R (rho p s).
Proof.
  apply Rle_trans with (2 := defect_small t0 (within t0 ltac:(pose proof lasts_pos; lra))). apply Rabs_pos.
Qed.

Lemma begin_u : (t0 - c) / S = IZR u0.
Proof. rewrite begins. field. exact S_not0. Qed.

Lemma distance t : t0 <= t <= t0 + Q2R lasts -> sqrt (1 * (x t - y t) ^ 2 + (v t - w t) ^ 2) <= Q2R after.
Proof.
  intros ht. pose proof rho_pos as hrho.
  assert (start : sqrt (1 * (x t0 - y t0) ^ 2 + (v t0 - w t0) ^ 2) <=
    Q2R e + Q2R (size (place p u0 - Y)) + Q2R (size (speed p s u0 - W))).
  { rewrite !size_is_Rabs, !Q2R_minus, Q2R_place, Q2R_speed by exact snot0. unfold near in near0.
    rewrite Rmult_1_l in *. unfold y, w. rewrite begin_u. fold S.
    set (a := value p (IZR u0) / m). set (b := value (diff p) (IZR u0) / (m * S)).
    replace (x t0 - a) with (x t0 - Q2R Y + (Q2R Y - a)) by ring.
    replace (v t0 - b) with (v t0 - Q2R W + (Q2R W - b)) by ring.
    apply Rle_trans with (1 := jump _ _ _ _).
    rewrite (Rabs_minus_sym (Q2R Y)), (Rabs_minus_sym (Q2R W)). lra. }
  assert (moved : sqrt (1 * (x t - y t) ^ 2 + (v t - w t) ^ 2) <=
    sqrt (1 * (x t0 - y t0) ^ 2 + (v t0 - w t0) ^ 2) + Q2R (rho p s) * (t - t0)).
  { apply (defect_bound 1 (Q2R (rho p s)) (fun u q => q = cubic u) (fun t => cubic (v t)) (fun t => cubic (w t))
      r x v y w) with (corners := []); [lra | exact cubic_is_monotone | lra | |].
    - intros t' ht' _.
      refine (conj (hx t' ltac:(lra)) (conj _ (conj eq_refl (conj (derive_y t') (conj (derive_w t') (conj eq_refl _)))))).
      + evar_last; [apply hv; lra | simpl; ring].
      + apply defect_small, within. lra.
    - intros t' ht'. refine (conj _ (conj _ (conj _ _))); apply continuity_pt_filterlim;
        [apply (ex_derive_continuous x) | apply (ex_derive_continuous v) | apply (ex_derive_continuous y) |
         apply (ex_derive_continuous w)]; eexists; [apply hx; lra | apply hv; lra | apply derive_y | apply derive_w]. }
  unfold after. rewrite !Q2R_plus, Q2R_mult.
  assert (Q2R (rho p s) * (t - t0) <= Q2R (rho p s) * Q2R lasts) by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma follows : near (t0 + Q2R lasts) (place p u1) (speed p s u1) after.
Proof.
  unfold near. rewrite Q2R_place, Q2R_speed by exact snot0.
  pose proof lasts_pos. pose proof (distance (t0 + Q2R lasts) ltac:(lra)) as h. unfold y, w in h.
  replace ((t0 + Q2R lasts - c) / S) with (IZR u1) in h; [exact h |].
  rewrite begins, lasts_S. field. exact S_not0.
Qed.

Lemma beside t : t0 <= t <= t0 + Q2R lasts -> Rabs (x t - y t) <= Q2R after /\ Rabs (v t - w t) <= Q2R after.
Proof.
  intros ht. pose proof (distance t ht) as h. split; apply Rle_trans with (2 := h).
  - pose proof (place_le 1 x v y w ltac:(lra) t) as hp. rewrite sqrt_1, Rmult_1_l in hp. exact hp.
  - exact (speed_le 1 x v y w ltac:(lra) t).
Qed.
End Piece.

Definition least (p : list Z) : Z := match p with [] => 0 | a :: q => a - norm q end.
Definition greatest (p : list Z) : Z := match p with [] => 0 | a :: q => a + norm q end.

Lemma between_them p u : Rabs u <= 1 -> IZR (least p) <= value p u <= IZR (greatest p).
Proof. intros hu. destruct p as [| a q]; [simpl; lra |]. now apply value_near_first. Qed.

Lemma less a b : (a < b)%Q -> Q2R a < Q2R b.
Proof. apply Qlt_Rlt. Qed.

Lemma Q2R_over z : Q2R (z # M) = IZR z / m.
Proof. reflexivity. Qed.

(* The piece that leaves: the acceleration is negative on all of it. *)
Definition fast (p : list Z) (s e : Q) : Q := (norm (diff p) # M) / size s + e.
Definition turns (x_far v_fast : Q) : Prop := (v_fast * v_fast * v_fast < 10 * x_far)%Q.

Lemma turns_R X V a b : (turns X V) -> Q2R X <= a -> Rabs b <= Q2R V -> Rabs (cubic b) < a.
Proof.
  unfold turns. intros h ha hb. apply less in h. rewrite !Q2R_mult in h.
  replace (Q2R 10) with 10 in h by (unfold Q2R; simpl; lra).
  unfold cubic, Rdiv. rewrite Rabs_mult, (Rabs_right (/ 10)) by lra. rewrite <- RPow_abs. pose proof (Rabs_pos b).
  assert (Rabs b ^ 3 <= Q2R V ^ 3) by (apply pow_incr; lra). nra.
Qed.

Lemma fast_R p s e c t0 u0 u1 Y W :
  ~ s == 0 -> (Z.abs u0 <= 1 /\ Z.abs u1 <= 1)%Z -> c = t0 - Q2R s * IZR u0 -> 0 <= t0 ->
  (0 <= s * inject_Z (u1 - u0))%Q -> near t0 Y W e ->
  forall t, t0 <= t <= t0 + Q2R (lasts s u0 u1) -> Rabs (v t) <= Q2R (fast p s (after p s u0 u1 Y W e)).
Proof.
  intros hs hu hc ht0 hf hn t ht.
  destruct (beside p s c hs u0 u1 t0 Y W e hu hc ht0 hf hn t ht) as (_ & hv').
  pose proof (within s c hs u0 u1 t0 hu hc t ht) as hu'.
  pose proof (value_le_norm (diff p) _ hu') as hw. pose proof m_pos.
  assert (hS : Q2R s <> 0) by (apply (S_not0 s hs)).
  unfold fast. rewrite Q2R_plus, Q2R_div, size_is_Rabs, Q2R_over.
  - set (w := value (diff p) ((t - c) / Q2R s) / (m * Q2R s)) in *.
    assert (Rabs w <= IZR (norm (diff p)) / m / Rabs (Q2R s)).
    { unfold w, Rdiv. rewrite Rabs_mult, Rabs_inv, Rabs_mult, (Rabs_right m) by lra.
      rewrite Rinv_mult, <- Rmult_assoc.
      apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat, Rabs_pos_lt, hS |].
      apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra | exact hw]. }
    pose proof (Rabs_triang (v t - w) w) as tri. replace (v t - w + w) with (v t) in tri by ring. lra.
  - unfold size, Qeq; simpl. intros h. apply hs. unfold Qeq; simpl. lia.
Qed.

Lemma place_R p s e c t0 u0 u1 Y W :
  ~ s == 0 -> (Z.abs u0 <= 1 /\ Z.abs u1 <= 1)%Z -> c = t0 - Q2R s * IZR u0 -> 0 <= t0 ->
  (0 <= s * inject_Z (u1 - u0))%Q -> near t0 Y W e ->
  forall t, t0 <= t <= t0 + Q2R (lasts s u0 u1) ->
  Q2R ((least p # M) - after p s u0 u1 Y W e) <= x t <= Q2R ((greatest p # M) + after p s u0 u1 Y W e).
Proof.
  intros hs hu hc ht0 hf hn t ht.
  destruct (beside p s c hs u0 u1 t0 Y W e hu hc ht0 hf hn t ht) as (hx' & _).
  pose proof (within s c hs u0 u1 t0 hu hc t ht) as hu'.
  destruct (between_them p _ hu') as (hl & hg). pose proof m_pos.
  rewrite Q2R_minus, Q2R_plus, !Q2R_over. set (q := value p ((t - c) / Q2R s)) in *.
  assert (IZR (least p) / m <= q / m <= IZR (greatest p) / m).
  { unfold Rdiv. split; apply Rmult_le_compat_r; try lra; left; apply Rinv_0_lt_compat; lra. }
  apply Rabs_le_between in hx'. lra.
Qed.

Lemma Q2R_0 : Q2R 0 = 0.
Proof. unfold Q2R; simpl; lra. Qed.

Lemma follows_Q p s u0 u1 (t : Q) Y W e : ~ s == 0 -> (Z.abs u0 <= 1 /\ Z.abs u1 <= 1)%Z -> (0 <= t)%Q ->
  (0 <= s * inject_Z (u1 - u0))%Q -> near (Q2R t) Y W e ->
  near (Q2R (t + lasts s u0 u1)) (place p u1) (speed p s u1) (after p s u0 u1 Y W e).
Proof.
  intros hs hu ht hf hn. rewrite Q2R_plus. apply Qle_Rle in ht. rewrite Q2R_0 in ht.
  now apply (follows p s (Q2R t - Q2R s * IZR u0) hs u0 u1 (Q2R t) Y W e hu eq_refl ht hf hn).
Qed.

Lemma speed_changes a b : 0 <= a < b -> exists q, a < q < b /\ v b - v a = (- x q - cubic (v q)) * (b - a).
Proof.
  intros hab. destruct (MVT_cor2 v (fun t => - x t - cubic (v t)) a b (proj2 hab)) as (q & h & hq).
  - intros t ht. apply is_derive_Reals, hv. lra.
  - exists q. split; assumption.
Qed.

Lemma leaves p s : x 0 = 1 -> v 0 = 0 -> (0 < s)%Q ->
  turns ((least p # M) - after p s 0 1 1 0 0) (fast p s (after p s 0 1 1 0 0)) ->
  near (Q2R (0 + lasts s 0 1)) (place p 1) (speed p s 1) (after p s 0 1 1 0 0) /\
  forall t, 0 < t <= Q2R (0 + lasts s 0 1) -> v t < 0.
Proof.
  intros h0 h1 hs hturn.
  assert (hs0 : ~ s == 0) by (intros h; rewrite h in hs; now apply Qlt_irrefl in hs).
  assert (hu : (Z.abs 0 <= 1 /\ Z.abs 1 <= 1)%Z) by (split; simpl; lia).
  assert (hf : (0 <= s * inject_Z (1 - 0))%Q).
  { simpl. setoid_replace (s * inject_Z 1)%Q with s by (unfold inject_Z; ring). now apply Qlt_le_weak. }
  assert (hn : near (Q2R 0) 1 0 0).
  { unfold near. rewrite Q2R_0, h0, h1. replace (Q2R 1) with 1 by (unfold Q2R; simpl; lra).
    replace (1 * (1 - 1) ^ 2 + (0 - 0) ^ 2) with 0 by ring. rewrite sqrt_0. lra. }
  split; [now apply follows_Q; [| | apply Qle_refl | |] |].
  intros t ht. rewrite Q2R_plus, Q2R_0, Rplus_0_l in ht. rewrite Q2R_0 in hn.
  destruct (speed_changes 0 t ltac:(lra)) as (q & hq & hc). rewrite h1 in hc.
  assert (hq' : 0 <= q <= 0 + Q2R (lasts s 0 1)) by lra.
  assert (hcc : 0 = 0 - Q2R s * IZR 0) by (simpl; ring).
  destruct (place_R p s 0 0 0 0 1 1 0 hs0 hu hcc ltac:(lra) hf hn q hq') as (hxq & _).
  pose proof (fast_R p s 0 0 0 0 1 1 0 hs0 hu hcc ltac:(lra) hf hn q hq') as hvq.
  pose proof (turns_R _ _ _ _ hturn hxq hvq) as hcub. apply Rabs_def2 in hcub. nra.
Qed.

(* The pieces that pass: the speed stays negative. *)
Fixpoint pass (ps : list (list Z * Q)) (t Y W e : Q) : option (Q * Q * Q * Q) :=
  match ps with
  | [] => Some (t, Y, W, e)
  | (p, s) :: rest =>
    let e' := after p s (-1) 1 Y W e in
    if (negb (Qle_bool s 0) && negb (Qle_bool 0 ((greatest (diff p) # M) / s + e')))%bool
    then pass rest (t + lasts s (-1) 1) (place p 1) (speed p s 1) e' else None
  end.

Lemma negb_le a b : negb (Qle_bool a b) = true -> (b < a)%Q.
Proof.
  intros h. apply Qnot_le_lt. intros hle. apply Qle_bool_iff in hle. rewrite hle in h. discriminate.
Qed.

Lemma passes ps : forall t Y W e t' Y' W' e', (0 <= t)%Q -> near (Q2R t) Y W e ->
  pass ps t Y W e = Some (t', Y', W', e') ->
  near (Q2R t') Y' W' e' /\ Q2R t <= Q2R t' /\ forall q, Q2R t < q <= Q2R t' -> v q < 0.
Proof.
  induction ps as [| (p, s) rest IH]; intros t Y W e t' Y' W' e' ht hn hp; simpl in hp.
  - injection hp as <- <- <- <-. repeat split; try assumption; try lra. intros q hq. lra.
  - destruct (negb (Qle_bool s 0)) eqn:hs; [| discriminate]. simpl in hp.
    destruct (negb (Qle_bool 0 ((greatest (diff p) # M) / s + after p s (-1) 1 Y W e))) eqn:hv'; [| discriminate].
    apply negb_le in hs. apply negb_le in hv'.
    assert (hs0 : ~ s == 0) by (intros h; rewrite h in hs; now apply Qlt_irrefl in hs).
    assert (hu : (Z.abs (-1) <= 1 /\ Z.abs 1 <= 1)%Z) by (split; simpl; lia).
    assert (hf : (0 <= s * inject_Z (1 - -1))%Q).
    { apply Qmult_le_0_compat; [now apply Qlt_le_weak | unfold inject_Z, Qle; simpl; lia]. }
    pose proof (follows_Q p s (-1) 1 t Y W e hs0 hu ht hf hn) as hn'.
    assert (ht' : (0 <= t + lasts s (-1) 1)%Q) by (apply (Qplus_le_compat 0 t 0 (lasts s (-1) 1)); assumption).
    destruct (IH _ _ _ _ _ _ _ _ ht' hn' hp) as (h1 & h2 & h3).
    assert (hl : 0 <= Q2R (lasts s (-1) 1)) by (rewrite <- Q2R_0; now apply Qle_Rle).
    rewrite Q2R_plus in h2, h3. split; [exact h1 |]. split; [lra |]. intros q hq.
    destruct (Rle_lt_dec q (Q2R t + Q2R (lasts s (-1) 1))) as [hin | hout]; [| apply h3; lra].
    assert (ht0 : 0 <= Q2R t) by (rewrite <- Q2R_0; now apply Qle_Rle).
    pose (c := Q2R t - Q2R s * IZR (-1)).
    destruct (beside p s c hs0 (-1) 1 (Q2R t) Y W e hu eq_refl ht0 hf hn q ltac:(lra)) as (_ & hb).
    pose proof (within s c hs0 (-1) 1 (Q2R t) hu eq_refl q ltac:(lra)) as hin'.
    destruct (between_them (diff p) _ hin') as (_ & hg).
    apply less in hv'. rewrite Q2R_plus, Q2R_div, Q2R_over, Q2R_0 in hv' by exact hs0.
    apply less in hs. rewrite Q2R_0 in hs. pose proof m_pos.
    set (g := value (diff p) ((q - c) / Q2R s)) in *.
    assert (g / (m * Q2R s) <= IZR (greatest (diff p)) / m / Q2R s).
    { unfold Rdiv. rewrite Rinv_mult, <- Rmult_assoc. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat |].
      apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra | exact hg]. }
    apply Rabs_le_between in hb. lra.
Qed.

(* The piece that arrives, at T and 2^-bits P(0): when the mass rests, and where. *)
Definition steady (p : list Z) : Z := match diff p with [] => 0 | _ :: q => least q end.
Definition tail (p : list Z) : Z := match p with [] => 0 | _ :: q => norm q end.
Definition far (p : list Z) (e : Q) : Q := - ((greatest p # M) + e).
Definition before (p : list Z) (s e : Q) : Q := e * inject_Z (Zpos M) * size s / inject_Z (steady p).
Definition beyond (p : list Z) (e : Q) : Q := e / far p e.
Definition within_of (p : list Z) (s e : Q) : Q := e + (before p s e * (tail p # M) + e * beyond p e).

Lemma continuous_v t : 0 <= t -> continuity_pt v t.
Proof. intros ht. apply continuity_pt_filterlim, (ex_derive_continuous v). eexists. apply hv, ht. Qed.

Lemma lands T c e : 0 <= T -> 0 < c -> x T <= - c -> - e <= v T <= 0 ->
  exists z, T <= z <= T + e / c /\ v z = 0 /\ (forall t, T <= t < z -> v t < 0) /\ Rabs (x z - x T) <= e * (e / c).
Proof.
  intros hT hc hxT hvT.
  destruct (landing 1 e c T cubic (fun t => - x t) (fun t => - v t)) as (z & hz & hvz & hmove & hplace); try lra.
  - intros u hu. unfold cubic. pose proof (pow_le u 3 hu). lra.
  - intros t ht. apply (is_derive_opp x). apply hx. lra.
  - intros t ht. evar_last; [apply (is_derive_opp v), hv; lra |]. unfold opp; simpl. unfold cubic. field.
  - rewrite Rmult_1_l in *. exists z. repeat split; try lra.
    + intros t ht. pose proof (hmove t ht). lra.
    + apply Rabs_le. lra.
Qed.

Lemma arrives p s (t Y W e : Q) : (0 <= t)%Q -> (s < 0)%Q -> near (Q2R t) Y W e -> v (Q2R t) < 0 ->
  let e' := after p s 1 0 Y W e in let T := (t + lasts s 1 0)%Q in
  turns (far p e') (fast p s e') -> (0 < far p e')%Q -> value_at (diff p) 0 = 0%Z -> (0 < steady p)%Z ->
  exists z, Q2R t < z /\ Q2R T - Q2R (before p s e' * size s) <= z <= Q2R T + Q2R (beyond p e') /\ v z = 0 /\
    (forall q, Q2R t <= q < z -> v q < 0) /\ Rabs (x z - Q2R (place p 0)) <= Q2R (within_of p s e').
Proof.
  intros ht hs hn hneg e' T hturn hfar hrest hsteady.
  assert (hs0 : ~ s == 0) by (intros h; rewrite h in hs; now apply Qlt_irrefl in hs).
  assert (hu : (Z.abs 1 <= 1 /\ Z.abs 0 <= 1)%Z) by (split; simpl; lia).
  assert (hf : (0 <= s * inject_Z (0 - 1))%Q).
  { destruct s as (n & d). unfold Qlt, Qle, Qmult, inject_Z in *; simpl in *. lia. }
  assert (ht0 : 0 <= Q2R t) by (rewrite <- Q2R_0; now apply Qle_Rle).
  assert (hl : 0 <= Q2R (lasts s 1 0)) by (rewrite <- Q2R_0; now apply Qle_Rle).
  assert (hT : Q2R T = Q2R t + Q2R (lasts s 1 0)) by apply Q2R_plus.
  pose proof m_pos as hm. apply less in hs. rewrite Q2R_0 in hs.
  pose proof hfar as hfarR. apply less in hfarR. rewrite Q2R_0 in hfarR.
  pose (c := Q2R t - Q2R s * IZR 1).
  (* On the piece the place is beyond, and the speed rises. *)
  assert (place_at : forall q, Q2R t <= q <= Q2R T -> x q <= - Q2R (far p e')).
  { intros q hq. rewrite hT in hq.
    destruct (place_R p s e c (Q2R t) 1 0 Y W hs0 hu eq_refl ht0 hf hn q hq) as (_ & h).
    unfold far. rewrite Q2R_opp, Ropp_involutive. exact h. }
  assert (rises : forall a b, Q2R t <= a < b -> b <= Q2R T -> v a < v b).
  { intros a b ha hb. destruct (speed_changes a b ltac:(lra)) as (q & hq & hc).
    assert (hq' : Q2R t <= q <= Q2R t + Q2R (lasts s 1 0)) by lra.
    pose proof (fast_R p s e c (Q2R t) 1 0 Y W hs0 hu eq_refl ht0 hf hn q hq') as hfast.
    pose proof (turns_R _ _ (Q2R (far p e')) (v q) hturn (Rle_refl _) hfast) as hcub.
    pose proof (place_at q ltac:(lra)). apply Rabs_def2 in hcub. nra. }
  assert (atT : Rabs (v (Q2R T)) <= Q2R e' /\ Rabs (x (Q2R T) - Q2R (place p 0)) <= Q2R e').
  { rewrite hT.
    destruct (beside p s c hs0 1 0 (Q2R t) Y W e hu eq_refl ht0 hf hn (Q2R t + Q2R (lasts s 1 0)) ltac:(lra))
      as (hb1 & hb2).
    assert (hu0 : (Q2R t + Q2R (lasts s 1 0) - c) / Q2R s = IZR 0).
    { unfold c. rewrite (lasts_S s 1 0). simpl. field. lra. }
    rewrite hu0 in hb1, hb2. rewrite Q2R_place. fold m. split; [| exact hb1].
    rewrite value_at_value, hrest in hb2. simpl in hb2. unfold Rdiv in hb2.
    rewrite Rmult_0_l, Rminus_0_r in hb2. exact hb2. }
  destruct atT as (hvT & hxT).
  assert (he : 0 <= Q2R e') by (apply Rle_trans with (2 := hvT); apply Rabs_pos).
  assert (hst : 0 < IZR (steady p)) by now apply (IZR_lt 0).
  assert (hbefore : Q2R (before p s e') = Q2R e' * m * - Q2R s / IZR (steady p)).
  { unfold before. rewrite Q2R_div by (unfold inject_Z, Qeq; simpl; lia).
    rewrite !Q2R_mult, !Q2R_whole, size_is_Rabs, Rabs_left by exact hs. reflexivity. }
  assert (hbef0 : 0 <= Q2R (before p s e')).
  { rewrite hbefore. apply Rmult_le_pos; [| left; now apply Rinv_0_lt_compat].
    apply Rmult_le_pos; [apply Rmult_le_pos |]; lra. }
  assert (hbeyond : Q2R (beyond p e') = Q2R e' / Q2R (far p e')).
  { unfold beyond. apply Q2R_div. intros h. rewrite h in hfar. now apply Qlt_irrefl in hfar. }
  assert (hbey0 : 0 <= Q2R (beyond p e')).
  { rewrite hbeyond. apply Rmult_le_pos; [exact he | left; now apply Rinv_0_lt_compat]. }
  assert (htail : 0 <= IZR (tail p) / m).
  { apply Rmult_le_pos; [| left; now apply Rinv_0_lt_compat]. unfold tail. destruct p as [| a q]; [simpl; lra |].
    apply Rle_trans with (2 := value_le_norm q 0 ltac:(rewrite Rabs_R0; lra)). apply Rabs_pos. }
  assert (hwithin : Q2R (within_of p s e') =
    Q2R e' + (Q2R (before p s e') * (IZR (tail p) / m) + Q2R e' * Q2R (beyond p e'))).
  { unfold within_of. now rewrite !Q2R_plus, !Q2R_mult, Q2R_over. }
  destruct (Rle_lt_dec 0 (v (Q2R T))) as [rested | moving].
  - (* It rests before T. *)
    destruct (first_zero (fun q => - v q) (Q2R t) (Q2R T)) as (z & hz & hvz & hmove); try lra.
    { intros q hq. apply continuity_pt_opp, continuous_v. lra. }
    exists z. assert (hvz' : v z = 0) by lra.
    assert (hzT : Q2R t <= z <= Q2R t + Q2R (lasts s 1 0)) by lra.
    destruct (beside p s c hs0 1 0 (Q2R t) Y W e hu eq_refl ht0 hf hn z hzT) as (hb1 & hb2).
    pose proof (within s c hs0 1 0 (Q2R t) hu eq_refl z hzT) as hu'.
    rewrite hvz' in hb2. fold e' in hb1, hb2.
    set (u := (z - c) / Q2R s) in *.
    assert (hu1 : 0 <= u /\ z = Q2R T - - Q2R s * u).
    { assert (Q2R s * u = z - c) by (unfold u; field; lra).
      assert (c = Q2R T) by (unfold c; rewrite hT, (lasts_S s 1 0); simpl; ring). split; nra. }
    destruct hu1 as (hu1 & hzu).
    assert (small : u * IZR (steady p) <= Q2R e' * m * - Q2R s).
    { unfold steady. destruct (diff p) as [| b q] eqn:hd.
      - simpl. rewrite Rmult_0_r. apply Rmult_le_pos; [apply Rmult_le_pos |]; lra.
      - assert (b = 0%Z) by (simpl in hrest; lia). subst b.
        destruct (between_them q u hu') as (hlow & _). simpl value in hb2.
        assert (hq : Rabs (0 - (0 + u * value q u) / (m * Q2R s)) = u * value q u / (m * - Q2R s)).
        { replace (0 - (0 + u * value q u) / (m * Q2R s)) with (u * value q u / (m * - Q2R s)) by (field; lra).
          apply Rabs_right. apply Rle_ge, Rmult_le_pos; [| left; apply Rinv_0_lt_compat; nra].
          apply Rmult_le_pos; [exact hu1 |]. unfold steady in hst. rewrite hd in hst. lra. }
        rewrite hq in hb2. apply (Rmult_le_compat_r (m * - Q2R s)) in hb2; [| nra].
        unfold Rdiv in hb2. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in hb2 by nra. nra. }
    assert (hub : u <= Q2R (before p s e')).
    { rewrite hbefore. apply (Rmult_le_reg_r (IZR (steady p))); [exact hst |].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. exact small. }
    assert (hsize : Q2R (size s) = - Q2R s) by (rewrite size_is_Rabs; now apply Rabs_left).
    rewrite Q2R_mult, hsize. repeat split; try lra.
    + rewrite hzu. nra.
    + intros q hq. pose proof (hmove q hq). lra.
    + (* y is as near to its last place as u says. *)
      rewrite hwithin, Q2R_place. simpl (IZR 0). unfold Rdiv in *.
      assert (near_end : Rabs (value p u * / m - value p 0 * / m) <= u * (IZR (tail p) * / m)).
      { unfold tail. destruct p as [| a q]; [simpl; rewrite !Rmult_0_l, Rminus_0_r, Rabs_R0; nra |]. simpl value.
        rewrite Rmult_0_l, Rplus_0_r.
        replace ((IZR a + u * value q u) * / m - IZR a * / m) with (u * value q u * / m) by ring.
        rewrite Rabs_mult, Rabs_mult, (Rabs_right u) by lra.
        rewrite (Rabs_right (/ m)) by (left; now apply Rinv_0_lt_compat).
        rewrite Rmult_assoc. apply Rmult_le_compat_l; [exact hu1 |].
        apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat | apply value_le_norm, hu']. }
      assert (u * (IZR (tail p) * / m) <= Q2R (before p s e') * (IZR (tail p) * / m)).
      { apply Rmult_le_compat_r; assumption. }
      pose proof (Rmult_le_pos _ _ he hbey0).
      pose proof (Rabs_triang (x z - value p u * / m) (value p u * / m - value p 0 * / m)) as tri.
      replace (x z - value p u * / m + (value p u * / m - value p 0 * / m)) with (x z - value p 0 * / m) in tri
        by ring.
      lra.
  - (* It rests after T. *)
    destruct (lands (Q2R T) (Q2R (far p e')) (Q2R e')) as (z & hz & hvz & hmove & hplace); try lra.
    { apply place_at. lra. }
    { apply Rabs_le_between in hvT. lra. }
    assert (0 <= Q2R (before p s e' * size s)).
    { rewrite Q2R_mult, size_is_Rabs. apply Rmult_le_pos; [exact hbef0 | apply Rabs_pos]. }
    assert (Q2R t < Q2R T) by (rewrite hT, (lasts_S s 1 0); simpl; lra).
    rewrite <- hbeyond in hz, hplace. exists z. rewrite hwithin. repeat split; try lra.
    + intros q hq. destruct (Rlt_le_dec q (Q2R T)) as [hin | hout]; [| apply hmove; lra].
      apply Rlt_trans with (2 := moving). apply rises; lra.
    + pose proof (Rabs_triang (x z - x (Q2R T)) (x (Q2R T) - Q2R (place p 0))) as tri.
      replace (x z - x (Q2R T) + (x (Q2R T) - Q2R (place p 0))) with (x z - Q2R (place p 0)) in tri by ring.
      pose proof (Rmult_le_pos _ _ hbef0 htail). lra.
Qed.

(* The whole half-swing: (place, within, first time, last time) of the turning point, where every inequality holds. *)
Definition turnsb (x_far v_fast : Q) : bool := negb (Qle_bool (10 * x_far) (v_fast * v_fast * v_fast)).

Definition run (leave : list Z * Q) (ps : list (list Z * Q)) (arrive : list Z * Q) : option (Q * Q * Q * Q) :=
  let (p0, s0) := leave in let (p1, s1) := arrive in let e0 := after p0 s0 0 1 1 0 0 in
  if (negb (Qle_bool s0 0) && turnsb ((least p0 # M) - e0) (fast p0 s0 e0))%bool then
    match pass ps (0 + lasts s0 0 1) (place p0 1) (speed p0 s0 1) e0 with
    | Some (t, Y, W, e) =>
      let e1 := after p1 s1 1 0 Y W e in let T := (t + lasts s1 1 0)%Q in
      if (negb (Qle_bool 0 s1) && turnsb (far p1 e1) (fast p1 s1 e1) && negb (Qle_bool (far p1 e1) 0) &&
          (value_at (diff p1) 0 =? 0)%Z && (0 <? steady p1)%Z)%bool
      then Some (place p1 0, within_of p1 s1 e1, (T - before p1 s1 e1 * size s1)%Q, (T + beyond p1 e1)%Q) else None
    | None => None
    end
  else None.

Lemma turnsb_turns a b : turnsb a b = true -> turns a b.
Proof. apply negb_le. Qed.

Theorem half_swing leave ps arrive X w first last : x 0 = 1 -> v 0 = 0 ->
  run leave ps arrive = Some (X, w, first, last) ->
  exists z, 0 < z /\ v z = 0 /\ (forall t, 0 < t < z -> v t < 0) /\
    Rabs (x z - Q2R X) <= Q2R w /\ Q2R first <= z <= Q2R last.
Proof.
  intros h0 h1 hrun. destruct leave as (p0, s0), arrive as (p1, s1). unfold run in hrun.
  destruct (negb (Qle_bool s0 0)) eqn:hs0; [| discriminate].
  destruct (turnsb ((least p0 # M) - after p0 s0 0 1 1 0 0) (fast p0 s0 (after p0 s0 0 1 1 0 0))) eqn:ht0;
    [| discriminate].
  cbn [andb] in hrun. apply negb_le in hs0. apply turnsb_turns in ht0.
  destruct (leaves p0 s0 h0 h1 hs0 ht0) as (hn0 & hneg0).
  destruct (pass ps (0 + lasts s0 0 1) (place p0 1) (speed p0 s0 1) (after p0 s0 0 1 1 0 0))
    as [(((t, Y), W), e) |] eqn:hp; [| discriminate].
  assert (hl0 : (0 < 0 + lasts s0 0 1)%Q).
  { destruct s0 as (n & d). unfold lasts, Qlt, Qplus, Qmult, inject_Z in *; simpl in *. lia. }
  destruct (passes ps _ _ _ _ _ _ _ _ (Qlt_le_weak _ _ hl0) hn0 hp) as (hn & ht & hneg).
  apply less in hl0. rewrite Q2R_0 in hl0.
  assert (downt : forall q, 0 < q <= Q2R t -> v q < 0).
  { intros q hq. destruct (Rle_lt_dec q (Q2R (0 + lasts s0 0 1))); [apply hneg0; lra | apply hneg; lra]. }
  set (e1 := after p1 s1 1 0 Y W e) in *.
  destruct (negb (Qle_bool 0 s1)) eqn:hs1; [| discriminate].
  destruct (turnsb (far p1 e1) (fast p1 s1 e1)) eqn:ht1; [| discriminate].
  destruct (negb (Qle_bool (far p1 e1) 0)) eqn:hf1; [| discriminate].
  destruct (value_at (diff p1) 0 =? 0)%Z eqn:hr1; [| discriminate].
  destruct (0 <? steady p1)%Z eqn:hst1; [| discriminate].
  cbn [andb] in hrun. injection hrun as <- <- <- <-.
  apply negb_le in hs1. apply turnsb_turns in ht1. apply negb_le in hf1. apply Z.eqb_eq in hr1.
  apply Z.ltb_lt in hst1.
  assert (htpos : (0 <= t)%Q) by (apply Rle_Qle; rewrite Q2R_0; lra).
  destruct (arrives p1 s1 t Y W e htpos hs1 hn (downt (Q2R t) ltac:(lra)) ht1 hf1 hr1 hst1)
    as (z & hz & htime & hvz & hdown & hplace).
  fold e1 in htime, hplace. exists z.
  rewrite (Q2R_minus (t + lasts s1 1 0)), (Q2R_plus (t + lasts s1 1 0) (beyond p1 e1)).
  refine (conj _ (conj hvz (conj _ (conj hplace htime)))); [lra |].
  intros q hq. destruct (Rle_lt_dec q (Q2R t)); [apply downt; lra | apply hdown; lra].
Qed.

(* What is printed: the place to within u, the time to within w. *)
Definition claims leave ps arrive (X u t w : Q) : bool :=
  match run leave ps arrive with
  | Some (place_z, within_z, first, last) =>
    Qle_bool (size (place_z - X) + within_z) u && Qle_bool (t - w) first && Qle_bool last (t + w)
  | None => false
  end.

Theorem turning_point leave ps arrive X u t w : x 0 = 1 -> v 0 = 0 -> claims leave ps arrive X u t w = true ->
  exists z, 0 < z /\ v z = 0 /\ (forall q, 0 < q < z -> v q < 0) /\
    Rabs (x z - Q2R X) <= Q2R u /\ Rabs (z - Q2R t) <= Q2R w.
Proof.
  unfold claims. intros h0 h1 h.
  destruct (run leave ps arrive) as [(((X', u'), first), last) |] eqn:hrun; [| discriminate].
  destruct (half_swing _ _ _ _ _ _ _ h0 h1 hrun) as (z & hz & hvz & hdown & hplace & htime).
  apply andb_prop in h as (h & hlast). apply andb_prop in h as (hu & hfirst).
  apply Qle_bool_iff, Qle_Rle in hu, hfirst, hlast.
  rewrite Q2R_plus, size_is_Rabs, Q2R_minus in hu. rewrite Q2R_minus in hfirst. rewrite Q2R_plus in hlast.
  exists z. refine (conj hz (conj hvz (conj hdown (conj _ _)))).
  - pose proof (Rabs_triang (x z - Q2R X') (Q2R X' - Q2R X)) as tri.
    replace (x z - Q2R X' + (Q2R X' - Q2R X)) with (x z - Q2R X) in tri by ring. lra.
  - apply Rabs_le. lra.
Qed.
End HalfSwing.

Print Assumptions turning_point.
