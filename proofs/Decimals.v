(* The decimals that are proved: each number lies between its two bounds, by the theorem that
   data/proved_decimals.csv names. Written from it by proofs/check --write-decimals; do not edit. *)
From Coq Require Import Reals.
Open Scope R_scope.

Definition fig2_parallel_cut_lower : R := 399201026045385125211245596857959 / 10 ^ 33.
Definition fig2_parallel_cut_upper : R := 399201026045385125211245596857960 / 10 ^ 33.
Definition fig2_parallel_gain_lower : R := 3327095867254834701629703 / 10 ^ 26.
Definition fig2_parallel_gain_upper : R := 3327095867254834701629704 / 10 ^ 26.
Definition fig3_cut_lower : R := 39358046189479500733531716068800 / 10 ^ 32.
Definition fig3_cut_upper : R := 39358046189479500733531716068801 / 10 ^ 32.
Definition fig3_gain_lower : R := 2223602811370093886112548 / 10 ^ 26.
Definition fig3_gain_upper : R := 2223602811370093886112549 / 10 ^ 26.
Definition information_cut_printed_1_lower : R := 482761524917779580189774170892 / 10 ^ 30.
Definition information_cut_printed_1_upper : R := 482761524917779580189774170893 / 10 ^ 30.
Definition information_cut_printed_2_lower : R := 607491150125974329105655431047 / 10 ^ 30.
Definition information_cut_printed_2_upper : R := 607491150125974329105655431048 / 10 ^ 30.
Definition information_cut_printed_3_lower : R := 684390212650305800231062362321 / 10 ^ 30.
Definition information_cut_printed_3_upper : R := 684390212650305800231062362322 / 10 ^ 30.
Definition information_cut_printed_4_lower : R := 736277763557794715491638694037 / 10 ^ 30.
Definition information_cut_printed_4_upper : R := 736277763557794715491638694038 / 10 ^ 30.
Definition information_cut_corrected_1_lower : R := 482761524917779580189774170892 / 10 ^ 30.
Definition information_cut_corrected_1_upper : R := 482761524917779580189774170893 / 10 ^ 30.
Definition information_cut_corrected_2_lower : R := 622369282329992550285413384224 / 10 ^ 30.
Definition information_cut_corrected_2_upper : R := 622369282329992550285413384225 / 10 ^ 30.
Definition information_cut_corrected_3_lower : R := 703398015615179600738410101406 / 10 ^ 30.
Definition information_cut_corrected_3_upper : R := 703398015615179600738410101407 / 10 ^ 30.
Definition information_cut_corrected_4_lower : R := 755999606513159509234971930477 / 10 ^ 30.
Definition information_cut_corrected_4_upper : R := 755999606513159509234971930478 / 10 ^ 30.
Definition mean_square_cut_1_lower : R := 499999999999999999999999999999 / 10 ^ 30.
Definition mean_square_cut_1_upper : R := 500000000000000000000000000001 / 10 ^ 30.
Definition mean_square_cut_2_lower : R := 640388203202207568727676231996 / 10 ^ 30.
Definition mean_square_cut_2_upper : R := 640388203202207568727676231997 / 10 ^ 30.
Definition mean_square_cut_3_lower : R := 719842074201091149829391328575 / 10 ^ 30.
Definition mean_square_cut_3_upper : R := 719842074201091149829391328576 / 10 ^ 30.
Definition mean_square_cut_4_lower : R := 770697495489133863164739966135 / 10 ^ 30.
Definition mean_square_cut_4_upper : R := 770697495489133863164739966136 / 10 ^ 30.
