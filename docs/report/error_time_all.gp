# gnuplot error_time_all.gp
$d0_0 << end
0.681389 1.27649
0.716712 0.252355
0.776991 0.230083
1.01376 0.0760727
1.91295 0.0249165
2.99038 0.0118688
5.82216 0.00480035
end
$d0_1 << end
1.37734 0.460009
1.27478 0.21298
2.77263 0.10942
3.76864 0.0317154
5.50768 0.0126698
end
$d0_2 << end
11.2146 0.397744
16.1858 0.217819
32.0344 0.122641
78.0673 0.0487473
end
$d0_3 << end
1.63724 16
1.69167 11.3714
0.765975 2.09387
1.53471 0.621945
4.67714 0.140438
15.6248 0.0166913
52.1821 0.0050057
end
$d0_4 << end
3.7023 16
4.77799 11.3714
7.50458 2.09387
22.0094 0.621945
39.0838 0.140438
end
$d0_5 << end
1.55223 16
1.60666 11.3714
0.719827 2.09387
1.37803 0.621945
8.42178 0.140438
end
$d0_6 << end
108.235 0.00543811
147.391 0.0136459
288.735 0.0136459
562.943 0.0136459
end
$d0_7 << end
42.5242 0.563902
113.041 0.638099
185.084 0.64648
325.441 0.664085
end
$d0_8 << end
261.651 0.140625
237.358 0.0318314
229.401 0.0114089
267.491 0.00626309
end
$d0_9 << end
79.8772 0.947749
162.142 0.947749
257.132 0.00777273
411.097 0.00160861
end
$d0_10 << end
197.893 16
198.89 16
196.129 16
191.457 16
end
$d0_11 << end
12.4977 0.518943
38.0791 0.122641
91.6816 0.0418987
191.339 0.0226721
end
$d0_12 << end
30.5318 0.00246026
77.9781 0.00246026
151.5 0.00159003
544.944 0.00159003
end
$d0_13 << end
185.371 18.3987
218.615 8.87488
326.745 4.22956
525.196 2.51603
end
$d0_14 << end
23.9189 0.1836
33.7081 0.0747686
36.9965 0.0161339
64.4287 0.0104229
end
$d1_0 << end
0.904279 0.756255
1.68956 0.477557
0.984419 0.177807
1.24772 0.106666
2.06803 0.0333622
2.94135 0.0199173
6.6433 0.00411116
end
$d1_1 << end
1.32241 0.376398
1.77862 0.166395
2.6338 0.0952735
4.54506 0.0327434
7.81876 0.0129553
end
$d1_2 << end
11.2767 0.482113
20.6796 0.254077
36.4841 0.133274
93.9934 0.0386115
end
$d1_3 << end
3.28391 16
3.72736 12.7659
3.21135 2.95896
1.49074 0.890052
4.34707 0.195142
13.4618 0.0726195
45.7479 0.0053543
end
$d1_4 << end
11.3316 16
8.51728 12.7659
12.2048 2.95896
22.3343 0.890052
42.8711 0.195142
end
$d1_5 << end
3.12609 16
3.48901 12.7659
3.20329 2.95896
1.44557 0.890052
4.08568 0.195142
end
$d1_6 << end
141.891 0.012605
306.715 0.0124757
593.554 0.0124757
987.493 0.0124757
end
$d1_7 << end
80.134 0.575845
225.028 0.666606
440.413 0.662536
717.477 0.662536
end
$d1_8 << end
408.465 0.148282
408.217 0.0282719
410.373 0.0123412
413.685 0.00602633
end
$d1_9 << end
123.557 0.0802299
235.002 0.0194055
396.838 0.00145289
end
$d1_10 << end
420.659 16
426.199 16
413.304 16
404.7 16
end
$d1_11 << end
16.4773 0.466252
47.338 0.123617
120.1 0.0525195
222.556 0.020202
end
$d1_12 << end
50.7406 0.00974676
193.814 0.011339
1048.61 0.00851493
3231.99 0.00109314
end
$d1_13 << end
252.486 33.8503
268.362 16.8807
335.137 8.23343
494.618 4.46822
end
$d1_14 << end
27.8705 0.237693
37.1502 0.0510987
53.1339 0.0348134
103.089 0.0103168
end
$d2_0 << end
1.91763 0.770465
1.82759 0.538295
1.9563 0.262023
2.2865 0.123842
3.79963 0.0577546
6.11214 0.0197638
12.3058 0.00405465
end
$d2_1 << end
1.53611 0.373918
2.09317 0.213234
2.81814 0.110943
5.09126 0.0448928
9.66027 0.0179569
end
$d2_2 << end
13.2951 0.614349
25.2796 0.338743
47.1593 0.150704
116.354 0.0586112
end
$d2_3 << end
3.15857 16
4.04247 7.54441
2.20295 1.70894
2.17935 0.621207
6.1827 0.150704
19.0697 0.0342275
66.6565 0.00456482
end
$d2_4 << end
5.74161 16
8.62148 7.54441
13.8017 1.70894
29.2244 0.621207
74.5457 0.150704
end
$d2_5 << end
3.08752 16
8.84486 7.54441
1.85439 1.70894
2.4089 0.621207
7.4491 0.150704
end
$d2_6 << end
138.123 0.0191395
333.724 0.00611559
669.009 0.00611559
1133.32 0.00611559
end
$d2_7 << end
70.3723 16
194.434 0.650576
400.179 0.615604
552.438 0.654771
end
$d2_8 << end
444.158 0.155623
457.319 0.0362423
421.75 0.0154842
422.402 0.00688986
end
$d2_9 << end
110.894 0.0966448
204.887 0.0212405
329.459 0.00357186
481.191 0.0021338
end
$d2_10 << end
348.675 16
352.125 16
352.747 16
362.164 16
end
$d2_11 << end
13.0434 0.522393
45.8388 0.150704
122.39 0.0460563
230.828 0.0238426
end
$d2_12 << end
50.072 0.0040789
138.426 0.00202439
288.122 0.00172007
772.823 0.000235021
end
$d2_13 << end
207.305 28.5754
237.403 12.7753
295.487 6.42935
433.732 3.1763
end
$d2_14 << end
30.5938 0.150704
47.3834 0.0783722
61.3378 0.0302396
147.881 0.00987679
end
$d3_0 << end
0.322177 0.2601
0.336318 0.0882841
0.350499 0.0851007
0.506971 0.0284899
0.70858 0.006824
end
$d3_1 << end
0.269289 0.431997
0.295427 0.219752
0.315968 0.0715586
0.471118 0.0273808
0.612738 0.00676757
end
$d3_2 << end
1.72492 0.533865
2.24769 0.176084
3.90853 0.138867
9.6401 0.0422841
end
$d3_3 << end
0.447133 4.58154
0.196351 1.23118
0.382918 0.347362
0.927804 0.0912411
2.90663 0.0117177
7.82913 0.00319568
24.1713 0.000802636
end
$d3_4 << end
0.724132 4.58154
0.780816 1.23118
1.28437 0.347362
2.6316 0.0912411
8.58288 0.0117177
end
$d3_5 << end
0.418941 4.58154
0.179936 1.23118
0.250911 0.347362
0.563184 0.0912411
1.8986 0.0117177
end
$d3_6 << end
13.0923 0.0161666
28.3304 0.0161666
72.1817 0.0161666
129.218 0.0161666
end
$d3_7 << end
13.7311 1.07474
32.09 0.678558
53.5049 0.68419
58.7493 0.661954
end
$d3_8 << end
54.2437 0.125155
54.3989 0.0090866
56.191 0.0090866
55.1468 0.00580957
end
$d3_9 << end
17.7815 1.01292
55.6137 0.837628
145.669 0.00119441
end
$d3_10 << end
50.6619 8.45753
51.7865 8.45753
51.6616 8.45753
52.8286 8.45753
end
$d3_11 << end
1.95674 0.488089
5.89425 0.100576
14.8369 0.0314993
29.7405 0.0206367
end
$d3_12 << end
5.5301 0.00110237
13.5477 0.000707021
24.5775 0.000902439
47.1482 0.00050257
end
$d3_13 << end
137.906 17.4516
164.516 8.2022
241.413 4.77779
420.409 1.89815
end
$d3_14 << end
4.22691 0.142958
4.93665 0.142958
6.52284 0.0585267
7.2217 0.0327248
end
$d4_0 << end
0.584746 0.294324
0.405772 0.117166
0.590675 0.0596952
0.591867 0.0316593
1.33192 0.00789777
end
$d4_1 << end
0.488414 0.214248
0.547831 0.134069
0.625797 0.0579277
0.56698 0.0206483
0.829449 0.0236108
end
$d4_2 << end
3.43412 0.676352
7.06003 0.19837
8.81439 0.187711
20.6626 0.0236108
end
$d4_3 << end
1.88947 9.52545
1.08114 2.68703
0.719646 0.768625
0.60752 0.171573
1.96429 0.0417236
7.0704 0.01182
27.8982 0.00127221
end
$d4_4 << end
1.76895 9.52545
1.9074 2.68703
2.3706 0.768625
3.63263 0.171573
8.01914 0.0417236
end
$d4_5 << end
1.16934 9.52545
0.923939 2.68703
0.678285 0.768625
0.780186 0.171573
1.87956 0.0417236
end
$d4_6 << end
51.0945 0.00646437
80.9361 0.00646437
174.795 0.00646437
292.91 0.00646437
end
$d4_7 << end
27.9647 16
63.5917 0.618896
107.877 0.636981
184.409 0.665414
end
$d4_8 << end
142.716 0.138234
143.547 0.0254922
end
$d4_9 << end
59.6544 1.07992
200.464 0.0047595
end
$d4_10 << end
165.773 16
142.463 16
144.859 16
145.117 16
end
$d4_11 << end
4.50232 0.657175
12.0356 0.136985
25.7435 0.0236108
48.4212 0.0236108
end
$d4_12 << end
15.2541 0.00143476
41.7949 0.00100023
82.0196 0.00127221
333.655 0.00127221
end
$d4_13 << end
229.124 40.7916
263.484 17.1306
380.311 11.6081
656.568 4.71935
end
$d4_14 << end
6.2535 0.171573
7.25476 0.114541
9.23641 0.0592309
17.9722 0.0238257
end
$d5_0 << end
0.372702 0.246396
0.531147 0.176901
0.47939 0.0757754
0.56012 0.0280046
0.680808 0.0157699
end
$d5_1 << end
0.41143 0.286548
0.37796 0.217291
0.49269 0.0919876
0.445911 0.0458824
0.622873 0.0157699
end
$d5_2 << end
1.06846 0.821871
1.89105 0.339211
3.35736 0.197577
7.25741 0.0611845
end
$d5_3 << end
0.738815 6.82294
0.204694 1.17148
0.319334 0.405697
0.9856 0.084288
3.34797 0.0181551
9.23207 0.00405588
27.0091 0.00142208
end
$d5_4 << end
0.787728 6.82294
1.01172 1.17148
1.48446 0.405697
2.97418 0.084288
8.13737 0.0181551
end
$d5_5 << end
0.555563 6.82294
0.19629 1.17148
0.292934 0.405697
0.929187 0.084288
3.03054 0.0181551
end
$d5_6 << end
16.5259 0.016656
29.0322 0.016656
61.0359 0.016656
101.9 0.016656
end
$d5_7 << end
9.31518 8.38636
23.0061 0.597742
43.9671 0.623981
60.3943 0.631364
end
$d5_8 << end
60.6072 0.153149
end
$d5_9 << end
17.6734 0.0692598
52.0862 0.0146969
108.493 0.00113168
end
$d5_10 << end
68.2364 0.10559
59.7498 0.0178989
58.9546 0.00398946
59.0643 0.00165677
end
$d5_11 << end
1.68589 0.264942
5.49142 0.106448
11.7134 0.00142208
22.3588 0.00140997
end
$d5_12 << end
5.46333 0.000894179
12.3248 0.000763817
24.4783 0.00140997
38.2822 0.00140997
end
$d5_13 << end
101.869 13.7542
121.144 6.43314
182.776 3.23415
305.59 1.72338
end
$d5_14 << end
4.18403 0.274238
4.44709 0.103817
4.8283 0.084288
7.85769 0.0279317
end
$d6_0 << end
0.690854 0.437158
0.965791 0.0674436
0.745194 0.0674436
1.29564 0.0317614
1.25404 0.00888459
end
$d6_1 << end
0.914045 0.48735
1.28816 0.2075
1.22683 0.096966
2.04903 0.0436791
2.14875 0.0182582
end
$d6_2 << end
3.78041 0.478035
5.78142 0.214926
9.52528 0.110032
21.8202 0.0338142
end
$d6_3 << end
2.92144 2.34843
0.922126 0.851351
0.93825 0.214926
3.17048 0.0289812
10.614 0.00639368
25.9818 0.000112701
85.2415 0.000112701
end
$d6_4 << end
5.17883 2.34843
8.56404 0.851351
10.232 0.214926
14.2527 0.0289812
38.9957 0.00639368
end
$d6_5 << end
2.70926 2.34843
0.826514 0.851351
0.803301 0.214926
2.06324 0.0289812
7.04532 0.00639368
end
$d6_6 << end
83.4275 0.0144088
169.569 0.0144088
372.319 0.0144088
600.591 0.0144088
end
$d6_7 << end
43.4122 0.61348
121.089 0.585633
246.748 0.600581
353.566 0.646489
end
$d6_8 << end
286.966 0.0114275
end
$d6_9 << end
87.6627 0.0293124
147.095 0.00789074
end
$d6_10 << end
296.715 0.0910757
294.447 0.0293124
end
$d6_11 << end
5.11344 0.404465
11.9328 0.128853
28.0141 0.317564
59.6692 0.0338142
end
$d6_12 << end
28.6802 0.000112701
86.6932 0.000112701
175.943 0.000315848
319.93 0.000112701
end
$d6_13 << end
169.096 13.1394
171.904 6.30183
212.758 3.97103
312.467 2.04498
end
$d6_14 << end
10.8619 0.214926
15.0071 0.214926
16.7718 0.0531925
19.5722 0.0129983
end
$d7_0 << end
1.02409 0.102831
0.996406 0.0872668
1.01025 0.0872668
1.08011 0.0245429
1.34321 0.00872391
end
$d7_1 << end
1.09126 0.124749
1.17826 0.124749
1.33561 0.0486149
1.70174 0.0181237
2.69665 0.0146743
end
$d7_2 << end
7.62267 0.231083
8.95874 0.142443
12.9866 0.0688788
26.8742 0.0381779
end
$d7_3 << end
4.86525 3.1378
5.30385 0.85607
2.16496 0.175312
2.18729 0.0381779
6.05689 0.00659181
20.4747 0.00213027
73.8128 0.000332701
end
$d7_4 << end
10.4905 3.1378
11.501 0.85607
14.0546 0.175312
19.6911 0.0381779
42.2274 0.00659181
end
$d7_5 << end
4.66964 3.1378
5.34722 0.85607
1.96238 0.175312
2.23006 0.0381779
5.95969 0.00659181
end
$d7_6 << end
173.713 0.00731614
452.825 0.00713256
854.163 0.00713256
1336.13 0.00713256
end
$d7_7 << end
115.914 0.602107
270.59 0.616223
576.065 0.616223
886.831 0.635802
end
$d7_8 << end
537.571 0.000332701
554.076 0.000332701
564.063 0.000332701
541.887 0.000332701
end
$d7_9 << end
8.66824 0.483683
19.1595 0.0769085
31.3519 0.0381779
60.2428 0.0199344
end
$d7_10 << end
61.3566 0.000332701
169.194 0.000332701
428.301 0.000332701
1729.89 0.000332701
end
$d7_11 << end
196.496 28.3646
217.547 11.8414
263.621 6.16002
365.488 2.83254
end
$d7_12 << end
17.1961 0.0868215
20.7648 0.0381779
23.9997 0.0231854
30.8724 0.00926024
end
$d8_0 << end
0.516335 0.409218
0.556024 0.130562
0.600679 0.134721
1.2767 0.0377867
1.21781 0.0201101
end
$d8_1 << end
0.673007 0.474817
0.826815 0.191897
1.00249 0.1043
1.56391 0.0457064
2.46871 0.0195869
end
$d8_2 << end
3.93832 0.453333
7.38706 0.377984
13.6796 0.103518
27.3627 0.0608294
end
$d8_3 << end
1.27394 2.44984
0.439711 0.639867
0.93128 0.194376
2.90662 0.037334
9.42511 0.00994697
33.8281 0.00248462
89.3959 0.00129747
end
$d8_4 << end
2.44388 2.44984
4.63799 0.639867
4.88204 0.194376
13.1289 0.037334
33.7093 0.00994697
end
$d8_5 << end
1.16784 2.44984
0.383198 0.639867
0.806885 0.194376
2.40217 0.037334
10.1269 0.00994697
end
$d8_6 << end
53.0867 0.0340913
116.564 0.0222283
226.148 0.0222283
374.046 0.0222283
end
$d8_7 << end
34.8267 0.65172
90.1957 0.624137
147.456 0.649739
242.372 0.643614
end
$d8_8 << end
191.213 0.169863
192.819 0.0369673
194.471 0.0106697
193.961 0.00465298
end
$d8_9 << end
36.6007 0.769102
63.087 0.769102
89.1517 0.769102
131.477 1.345
end
$d8_10 << end
168.161 0.103563
169.34 0.00931606
175.456 0.00697734
177.678 0.00191904
end
$d8_11 << end
5.10104 0.547824
12.5137 0.10052
29.6281 0.0521723
59.4233 0.0293478
end
$d8_12 << end
19.8022 0.00108194
53.398 0.678551
118.224 0.666698
218.849 0.678551
end
$d8_13 << end
197.373 17.5043
188.672 9.07526
220.404 4.65613
311.711 2.08489
end
$d8_14 << end
7.91948 0.194376
10.2542 0.0795511
10.3072 0.0795511
15.8734 0.0293478
end
$d9_0 << end
2.75172 0.496405
3.16773 0.128249
3.30007 0.127776
4.25346 0.0499481
5.83721 0.0275697
end
$d9_1 << end
3.19673 0.685299
3.7142 0.213831
4.23607 0.118751
5.64679 0.0635638
7.88221 0.0233497
end
$d9_2 << end
9.91765 0.495956
16.5592 0.286077
33.0647 0.150413
76.6744 0.0784139
end
$d9_3 << end
2.23495 3.12366
1.74516 0.836907
4.94024 0.247131
14.7726 0.0665993
48.4272 0.00850119
end
$d9_4 << end
5.3906 3.12366
9.2981 0.836907
23.4348 0.247131
73.4346 0.0665993
end
$d9_5 << end
1.81397 3.12366
1.56211 0.836907
4.16008 0.247131
14.0314 0.0665993
end
$d9_6 << end
71.083 0.0202976
142.039 0.00876149
279.305 0.00876149
488.04 0.00876149
end
$d9_7 << end
40.7606 1.81597
97.9884 0.601578
171.296 0.675885
267.991 0.636386
end
$d9_8 << end
233.933 0.149426
236.127 0.0360529
238.296 0.0157577
240.515 0.00862334
end
$d9_9 << end
98.4643 0.0822869
186.895 0.02223
298.155 0.00543481
466.017 0.00486266
end
$d9_10 << end
216.138 2.41669
203.317 2.41669
201.939 2.41669
216.241 2.41669
end
$d9_11 << end
14.4299 0.387375
50.6083 0.107193
111.905 0.0487828
206.767 0.0239044
end
$d9_12 << end
25.5353 0.0120119
63.6757 0.0011598
127.703 0.000452236
211.539 0.00149167
end
$d9_13 << end
136.217 11.8326
156.124 7.44346
206.002 3.33876
310.885 1.52939
end
$d9_14 << end
22.737 0.256166
23.6064 0.256166
37.2055 0.0848854
50.3283 0.0665993
end
$d10_0 << end
2.6982 0.263987
3.03433 0.242959
3.11958 0.143692
4.78696 0.0528481
5.40412 0.0226918
end
$d10_1 << end
3.59859 0.543688
4.33753 0.276982
5.05683 0.120338
7.82958 0.0516379
9.96834 0.024345
end
$d10_2 << end
12.0508 0.473492
21.8669 0.192967
40.0594 0.148114
99.2772 0.0438457
end
$d10_3 << end
3.7045 5.28405
1.90725 1.3061
4.3197 0.383861
14.4382 0.0909569
46.1881 0.0174457
end
$d10_4 << end
9.52205 5.28405
12.9772 1.3061
25.3789 0.383861
82.3709 0.0909569
end
$d10_5 << end
3.17288 5.28405
1.60342 1.3061
3.88465 0.383861
12.0914 0.0909569
end
$d10_6 << end
152.017 0.00911068
299.313 0.00321158
625.61 0.00506085
1040.89 0.00506085
end
$d10_7 << end
78.3241 0.628235
211.622 0.610583
376.842 0.628481
614.752 0.683871
end
$d10_8 << end
444.267 0.15301
447.638 0.0380473
448.955 0.0123264
452.437 0.00791634
end
$d10_9 << end
155.652 0.0959039
300.567 0.0199104
482.024 0.00803893
683.574 0.00198377
end
$d10_10 << end
409.735 1.60116
410.84 1.60116
436.516 1.60116
422.802 1.60116
end
$d10_11 << end
16.152 0.481089
51.9738 0.10186
141.745 0.0438457
247.634 0.0268417
end
$d10_12 << end
50.2004 0.000840187
132.978 0.00149918
454.236 0.00126979
end
$d10_13 << end
225.836 26.4744
266.016 13.0583
350.048 6.64838
526.041 2.89832
end
$d10_14 << end
31.8336 0.383861
45.04 0.234303
59.8817 0.0909569
99.6448 0.0466781
end
$d11_0 << end
2.93954 0.345056
2.89985 0.159376
3.71934 0.106179
4.43201 0.0523258
5.59981 0.0267119
end
$d11_1 << end
3.28218 0.491808
3.35071 0.310184
4.52054 0.126328
6.49019 0.054526
8.5296 0.0307251
end
$d11_2 << end
12.3512 0.614287
17.8548 0.355659
35.4278 0.109309
82.7656 0.0404731
end
$d11_3 << end
3.23416 3.65155
1.76106 1.04791
4.65554 0.288699
14.3136 0.0587762
63.54 0.0138196
end
$d11_4 << end
5.60544 3.65155
9.44601 1.04791
22.7177 0.288699
78.0221 0.0587762
end
$d11_5 << end
1.9026 3.65155
1.44724 1.04791
3.88189 0.288699
13.2047 0.0587762
end
$d11_6 << end
75.6816 0.012271
147.496 0.012271
286.28 0.012271
529.73 0.012271
end
$d11_7 << end
39.0388 0.620711
103.472 0.624
172.679 0.675235
294.574 0.664088
end
$d11_8 << end
236.548 0.155599
231.922 0.0409791
234.998 0.0164609
259.651 0.00705221
end
$d11_9 << end
96.2819 0.112191
176.946 0.0275975
277.582 0.00812331
426.387 8.66248e-05
end
$d11_10 << end
182.383 1.51534
184.354 1.51534
186.073 1.51534
190.305 1.51534
end
$d11_11 << end
13.0262 0.481956
48.8846 0.109309
104.64 0.054526
224.212 0.0242105
end
$d11_12 << end
23.9441 0.00561576
69.5797 0.00230231
136.392 0.00124907
210.967 0.00135887
end
$d11_13 << end
112.744 18.2891
134.111 8.98901
171.715 4.50026
249.676 2.254
end
$d11_14 << end
21.8389 0.288699
24.7673 0.288699
33.7727 0.0929819
61.8927 0.0404731
end
$d12_0 << end
14.2557 0.242011
14.6018 0.152234
16.9039 0.0694318
21.0577 0.0298556
25.2132 0.0143453
end
$d12_1 << end
15.5326 0.381005
17.6931 0.242011
22.0034 0.0834074
20.5912 0.0437911
27.9108 0.0143453
end
$d12_2 << end
31.0346 0.578935
54.6544 0.337727
99.4348 0.138599
228.285 0.035524
end
$d12_3 << end
3.77925 0.969862
8.61398 0.211598
23.3746 0.0394482
66.1681 0.0113739
end
$d12_4 << end
10.4483 0.969862
23.4015 0.211598
70.7507 0.0394482
end
$d12_5 << end
2.01296 0.969862
5.64794 0.211598
18.9139 0.0394482
end
$d12_6 << end
151.6 0.0357932
277.352 0.0174715
514.388 0.0174715
866.244 0.0174715
end
$d12_7 << end
93.5451 16
219.165 0.54363
356.017 0.598398
515.443 0.63027
end
$d12_8 << end
546.793 0.132094
543.541 0.0285002
549.884 0.00955743
558.468 0.00553949
end
$d12_9 << end
118.186 16
206.966 0.0171948
341.586 0.00447538
512.33 0.000116097
end
$d12_10 << end
424.369 16
399.74 16
399.602 16
409.273 16
end
$d12_11 << end
27.264 16
91.7832 16
222.465 16
440.845 0.798322
end
$d12_12 << end
52.5916 0.000466313
119.631 0.000466313
218.238 0.000466313
384.402 0.000466313
end
$d12_13 << end
266.021 63.2139
278.027 45.5494
334.831 17.2114
499.138 7.91942
end
$d12_14 << end
77.7573 0.0394482
88.084 0.0394482
122.541 0.012691
168.31 0.00268785
end
$d13_0 << end
9.99162 0.268983
10.9295 0.174134
11.8164 0.102036
15.1884 0.0242444
18.9109 0.0138848
end
$d13_1 << end
8.75069 0.345527
9.71946 0.298992
12.9597 0.115417
17.3761 0.0446806
23.203 0.0171081
end
$d13_2 << end
27.5921 0.424949
49.1343 0.230491
86.7949 0.103092
199.829 0.0255139
end
$d13_3 << end
3.339 0.775775
6.03455 0.158495
18.0023 0.024857
57.2612 0.00618285
end
$d13_4 << end
9.80966 0.775775
19.7593 0.158495
59.0502 0.024857
end
$d13_5 << end
2.40535 0.775775
4.89398 0.158495
16.1267 0.024857
end
$d13_6 << end
168.271 0.0138848
306.661 0.000589907
598.128 0.000589907
1009.07 0.000589907
end
$d13_7 << end
102.292 16
227.741 0.627358
393.177 0.687581
621.321 0.654962
end
$d13_8 << end
556.46 0.154575
556.417 0.0292246
558.669 0.0152017
574.719 0.0044893
end
$d13_9 << end
92.3979 0.334281
162.42 16
246.552 16
347.003 16
end
$d13_10 << end
433.285 16
405.602 11.0932
402.99 1.07145
404.931 1.07145
end
$d13_11 << end
24.3862 16
83.42 16
204.928 0.0255139
417.893 0.313017
end
$d13_12 << end
64.3741 0.00180089
171.52 0.00180089
265.868 16
540.033 0.000589907
end
$d13_13 << end
380.299 22.8634
367.207 10.5501
369.878 6.13612
526.397 2.50865
end
$d13_14 << end
46.9334 0.024857
79.0684 0.00914146
124.059 0.00618285
331.187 0.000589907
end
$d14_0 << end
22.4632 0.147679
14.3248 0.0723985
16.6901 0.0338369
20.8904 0.0177094
24.4987 0.00999439
end
$d14_1 << end
12.8313 0.470219
13.841 0.24068
15.2064 0.050068
18.5642 0.0177094
21.1081 0.00999439
end
$d14_2 << end
16.7564 0.405303
24.0876 0.314287
41.7261 0.0958438
83.7017 0.0463156
end
$d14_3 << end
3.80255 0.0919171
8.47673 0.0141345
27.8077 0.00105269
82.3797 0.000467914
end
$d14_4 << end
11.1668 0.0919171
29.6506 0.0141345
118.563 0.00105269
end
$d14_5 << end
1.97371 0.0919171
6.29344 0.0141345
24.1119 0.00105269
end
$d14_6 << end
58.3367 0.00999439
133.543 0.00999439
260.513 0.00999439
488.67 0.00999439
end
$d14_7 << end
71.2233 0.582201
156.852 0.549583
278.061 0.58987
405.584 0.58987
end
$d14_8 << end
141.292 0.993697
299.183 0.774162
532.708 0.00999439
810.618 0.00030911
end
$d14_9 << end
387.231 16
377.149 16
378.678 16
end
$d14_10 << end
20.8039 0.2045
71.7529 1.03321
161.709 0.0141345
316.8 0.00645517
end
$d14_11 << end
38.3858 0.00105269
72.541 0.122034
127.522 0.00030911
223.041 0.000137293
end
$d14_12 << end
143.396 15.339
164.227 7.50831
210.712 3.68713
309.967 1.70252
end
$d14_13 << end
38.8383 0.0141345
27.4561 0.0141345
27.2942 0.0141345
67.1974 0.00105269
end
set logscale xy
set grid xtics ytics lt 1 lw 1 lc rgb '#dddddd'
set format xy '%g'
set border 3
set tics nomirror
set terminal svg size 1260,1306 font 'sans,9' dynamic background rgb 'white'
set output 'error_time_all.svg'
set multiplot layout 5,3
unset label
unset key
set title 'teapot, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.487014:2307.01]
set yrange [0.000995947:35.418]
set label 'kept' at graph 0.8295,0.0200 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7962,0.0769 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2932,0.1501 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5523,0.1341 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7454,0.1909 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5772,0.2241 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2866,0.2427 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2479 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.7058,0.3047 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5999,0.3713 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5181,0.4723 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3368,0.4723 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7686,0.6205 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8251,0.7476 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7059,0.9242 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d0_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d0_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d0_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d0_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d0_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d0_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'teapot, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.600681:18015]
set yrange [0.000651826:69.8111]
set label 'kept' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.6299,0.0692 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2331,0.1590 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.4203,0.1419 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.6339,0.1987 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.4991,0.2385 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.7183,0.2555 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2489,0.2581 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.5738,0.3124 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.4902,0.3692 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4140,0.4923 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.1860,0.4923 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.6873,0.5979 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6512,0.7627 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6318,0.8728 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d1_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d1_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d1_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d1_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d1_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d1_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d1_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d1_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d1_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d1_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d1_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d1_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d1_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d1_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d1_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'teapot, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.10414:4535.42]
set yrange [0.000130877:64.8536]
set label 'kept' at graph 0.7873,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7304,0.2126 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2898,0.2618 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.4928,0.2709 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2694 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7147,0.3263 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5886,0.3297 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2607,0.3753 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.6421,0.3969 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5598,0.4655 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5063,0.5375 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2294,0.5375 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7470,0.6495 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7179,0.7700 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6962,0.8933 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d2_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d2_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d2_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d2_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d2_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d2_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d2_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d2_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d2_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d2_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d2_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d2_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d2_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d2_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d2_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.122093:2143.23]
set yrange [0.000297965:36.2811]
set label 'kept' at graph 0.6095,0.0257 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'tessellation' at graph 0.5411,0.0827 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'whitted' at graph 0.7249,0.1395 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'scanline' at graph 0.6255,0.2537 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'fd' at graph 0.1651,0.2386 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1799,0.2955 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.4352,0.3136 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2808,0.3136 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.7126,0.3196 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.5623,0.3765 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4175,0.3872 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4470,0.4441 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.6320,0.6581 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7480 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6211,0.8756 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d3_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d3_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d3_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d3_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d3_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d3_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d3_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d3_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d3_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d3_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d3_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d3_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d3_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d3_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d3_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.280435:3098.63]
set yrange [0.00058827:85.7637]
set label 'tessellation' at graph 0.4941,0.0649 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'kept' at graph 0.7606,0.0649 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7059,0.1602 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'micropolygons' at graph 0.7466,0.2172 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.1673,0.2184 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1165,0.3105 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4618,0.2604 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.5533,0.3565 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4469,0.3172 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.6700,0.2995 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.3602,0.3742 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2043,0.3584 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.6969,0.5913 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7561 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6712,0.8588 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d4_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d4_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d4_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d4_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d4_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d4_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d4_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d4_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d4_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d4_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d4_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d4_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d4_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d4_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d4_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.135921:1430.57]
set yrange [0.000467969:27.3097]
set label 'whitted' at graph 0.7215,0.0313 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'lane-carpenter' at graph 0.5510,0.2020 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'kept' at graph 0.6090,0.0313 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'tessellation' at graph 0.5714,0.1451 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.6559,0.0882 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'afd' at graph 0.1740,0.2920 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1644,0.3490 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7148,0.3255 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'zsort' at graph 0.4418,0.2855 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3352,0.3424 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.4381,0.3993 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4295,0.4562 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'scanline' at graph 0.6587,0.5277 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'isocurves' at graph 0.6583,0.6567 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7482 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d5_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d5_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d5_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d5_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d5_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d5_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d5_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d5_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d5_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d5_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d5_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d5_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d5_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d5_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d5_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.492523:2487.76]
set yrange [6.2892e-05:29.7331]
set label 'tessellation' at graph 0.6044,0.0200 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'kept' at graph 0.7595,0.0768 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'zsort' at graph 0.5127,0.3524 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3120,0.3530 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'whitted' at graph 0.6684,0.3296 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.1096,0.3780 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'scanline' at graph 0.7467,0.3864 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.4318,0.4100 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4453 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.1727,0.4349 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'blinn' at graph 0.7497,0.5115 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'subdivision' at graph 0.4446,0.5002 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.5625,0.4434 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'isocurves' at graph 0.7712,0.7070 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7567,0.7951 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d6_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d6_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d6_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d6_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d6_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d6_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d6_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d6_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d6_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d6_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d6_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d6_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d6_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d6_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d6_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.68621:8285.73]
set yrange [0.00018859:62.7953]
set label 'tessellation' at graph 0.4977,0.0200 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.7098,0.0768 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'kept' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'zsort' at graph 0.4383,0.2572 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2300,0.2795 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.8059,0.2857 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.0715,0.2935 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'mesa' at graph 0.4050,0.3140 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.1456,0.3505 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.4761,0.3709 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.3902,0.4278 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7622,0.6388 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6679,0.7563 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d7_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d7_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d7_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d7_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d7_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d7_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d7_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d7_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d7_8 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d7_9 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d7_10 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d7_11 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d7_12 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.271611:1587.52]
set yrange [0.000666432:34.4962]
set label 'tessellation' at graph 0.6683,0.0509 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.7475,0.1079 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'scanline' at graph 0.7576,0.1790 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.5559,0.2206 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.4172,0.2775 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'fd' at graph 0.2545,0.3115 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1730,0.3139 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3057 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.6212,0.3625 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4690,0.3487 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5318,0.4195 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7833,0.5932 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'kept' at graph 0.7715,0.6500 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7128,0.7069 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'voxels' at graph 0.8123,0.7638 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d8_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d8_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d8_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d8_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d8_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d8_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d8_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d8_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d8_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d8_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d8_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d8_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d8_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d8_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d8_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.17213:1630.62]
set yrange [0.000271944:24.1168]
set label 'kept' at graph 0.7178,0.1494 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.8270,0.2283 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'tessellation' at graph 0.5141,0.3022 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7356,0.3420 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2851 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2633,0.3696 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.7147,0.3988 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.2218,0.4266 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.5717,0.4307 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3430,0.4828 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5195,0.5444 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5776,0.4877 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7505,0.6810 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7710,0.7495 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7209,0.8065 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d9_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d9_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d9_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d9_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d9_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d9_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d9_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d9_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d9_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d9_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d9_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d9_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d9_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d9_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d9_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.15992:4055.08]
set yrange [0.000500557:54.666]
set label 'kept' at graph 0.7317,0.0710 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7818,0.1280 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1902 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7312,0.2472 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4516,0.2901 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.1886,0.3033 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2636,0.3603 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.6574,0.3470 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5453,0.4124 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5458,0.3555 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5225,0.4693 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2873,0.4484 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7688,0.6223 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7229,0.6928 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7497,0.7497 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d10_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d10_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d10_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d10_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d10_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d10_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d10_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d10_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d10_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d10_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d10_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d10_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d10_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d10_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d10_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.07737:1829.75]
set yrange [4.69261e-05:43.143]
set label 'whitted' at graph 0.8042,0.0446 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'kept' at graph 0.7095,0.2451 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'scanline' at graph 0.7375,0.3412 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4058 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5482,0.3980 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'lane-carpenter' at graph 0.7177,0.4629 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.2216,0.4277 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2782,0.4846 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5837,0.5686 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5447,0.4550 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5758,0.5118 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3370,0.5414 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7544,0.6889 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.6957,0.7457 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7322,0.8026 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d11_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d11_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d11_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d11_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d11_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d11_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d11_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d11_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d11_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d11_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d11_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d11_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d11_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d11_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d11_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.48643:3095.56]
set yrange [5.99821e-05:159.343]
set label 'whitted' at graph 0.7646,0.0446 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'kept' at graph 0.7270,0.1386 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'mesa' at graph 0.6189,0.2571 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7759,0.3059 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4967,0.3546 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3705,0.3362 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3838,0.3930 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3791 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.6588,0.4361 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5055,0.4386 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3329,0.4500 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7654,0.6055 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'lane-carpenter' at graph 0.7449,0.6625 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'voxels' at graph 0.7612,0.7924 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7352,0.8493 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d12_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d12_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d12_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d12_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d12_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d12_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d12_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d12_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d12_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d12_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d12_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d12_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d12_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d12_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d12_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.77845:3586.72]
set yrange [0.000347829:47.8989]
set label 'micropolygons' at graph 0.8333,0.0200 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'kept' at graph 0.7512,0.0874 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'mesa' at graph 0.6869,0.0304 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7594,0.2162 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4563,0.2432 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3107,0.2770 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3376,0.3339 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'zsort' at graph 0.4603,0.3608 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2897,0.3907 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.6205,0.3630 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.7175,0.5735 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'isocurves' at graph 0.7696,0.6303 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7133,0.6872 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7478,0.7508 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'whitted' at graph 0.6931,0.9073 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
plot $d13_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d13_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d13_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d13_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d13_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d13_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d13_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d13_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d13_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d13_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d13_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d13_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d13_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d13_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d13_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.46085:2868.52]
set yrange [7.66169e-05:36.2054]
set label 'kept' at graph 0.6631,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.8333,0.1068 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'tessellation' at graph 0.5318,0.1268 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.5798,0.1838 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3698,0.1863 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5049,0.2433 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'lane-carpenter' at graph 0.7094,0.3276 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.3719,0.3443 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3522,0.4013 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7666,0.3846 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5339,0.4902 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7420,0.6849 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7066,0.7660 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7330,0.9375 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d14_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d14_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d14_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d14_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d14_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d14_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d14_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d14_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d14_8 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d14_9 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d14_10 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d14_11 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d14_12 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d14_13 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset multiplot
set output
set terminal pngcairo size 1540,1586 font 'sans,8' background rgb 'white'
set output 'error_time_all.png'
set multiplot layout 5,3
unset label
unset key
set title 'teapot, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.487014:2307.01]
set yrange [0.000995947:35.418]
set label 'kept' at graph 0.8295,0.0260 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7962,0.0644 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2932,0.1501 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5523,0.1541 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7454,0.1755 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5772,0.2241 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2866,0.2427 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2498 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.7058,0.2982 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5999,0.3713 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5181,0.4723 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3368,0.4723 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7686,0.6205 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8251,0.7476 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7059,0.9242 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d0_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d0_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d0_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d0_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d0_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d0_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'teapot, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.600681:18015]
set yrange [0.000651826:69.8111]
set label 'kept' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.6299,0.0692 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2331,0.1590 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.4203,0.1818 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.6339,0.1920 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.4991,0.2385 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.7183,0.2549 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2489,0.2581 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.5738,0.2965 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.4902,0.3524 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4140,0.4923 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.1860,0.4923 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.6873,0.5979 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6512,0.7627 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6318,0.8728 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d1_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d1_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d1_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d1_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d1_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d1_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d1_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d1_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d1_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d1_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d1_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d1_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d1_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d1_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d1_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'teapot, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.10414:4535.42]
set yrange [0.000130877:64.8536]
set label 'kept' at graph 0.7873,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7304,0.2129 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2898,0.2618 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.4928,0.2709 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2932 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7147,0.3023 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5886,0.3297 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2607,0.3753 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.6421,0.3969 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5598,0.4655 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5063,0.5375 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2294,0.5375 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7470,0.6495 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7179,0.7700 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6962,0.8933 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d2_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d2_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d2_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d2_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d2_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d2_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d2_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d2_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d2_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d2_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d2_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d2_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d2_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d2_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d2_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.122093:2143.23]
set yrange [0.000297965:36.2811]
set label 'kept' at graph 0.6095,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'tessellation' at graph 0.5411,0.0846 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'whitted' at graph 0.7249,0.1186 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'scanline' at graph 0.6255,0.2537 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'fd' at graph 0.1651,0.2478 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1799,0.2863 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.4352,0.3136 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2808,0.3136 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.7126,0.3322 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.5623,0.3707 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4175,0.3930 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4470,0.4315 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.6320,0.6581 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7480 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6211,0.8756 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d3_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d3_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d3_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d3_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d3_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d3_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d3_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d3_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d3_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d3_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d3_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d3_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d3_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d3_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d3_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.280435:3098.63]
set yrange [0.00058827:85.7637]
set label 'tessellation' at graph 0.4941,0.0649 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'kept' at graph 0.7606,0.0649 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7059,0.1695 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'micropolygons' at graph 0.7466,0.2080 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.1673,0.2184 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1165,0.3105 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4618,0.2821 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.5533,0.3426 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4469,0.3205 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.6700,0.3041 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.3602,0.3584 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2043,0.3584 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.6969,0.5913 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7561 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6712,0.8588 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d4_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d4_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d4_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d4_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d4_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d4_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d4_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d4_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d4_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d4_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d4_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d4_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d4_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d4_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d4_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.135921:1430.57]
set yrange [0.000467969:27.3097]
set label 'whitted' at graph 0.7215,0.0535 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'lane-carpenter' at graph 0.5510,0.1687 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'kept' at graph 0.6090,0.0535 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'tessellation' at graph 0.5714,0.1303 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.6559,0.0919 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'afd' at graph 0.1740,0.3013 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1644,0.3398 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7148,0.3255 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'zsort' at graph 0.4418,0.3334 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3352,0.3334 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.4381,0.3726 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4295,0.4441 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'scanline' at graph 0.6587,0.5277 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'isocurves' at graph 0.6583,0.6567 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7482 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d5_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d5_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d5_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d5_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d5_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d5_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d5_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d5_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d5_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d5_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d5_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d5_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d5_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d5_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d5_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.492523:2487.76]
set yrange [6.2892e-05:29.7331]
set label 'tessellation' at graph 0.6044,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'kept' at graph 0.7595,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'zsort' at graph 0.5127,0.3537 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3120,0.3537 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'whitted' at graph 0.6684,0.3562 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.1096,0.3789 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'scanline' at graph 0.7467,0.3946 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.4318,0.4080 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4330 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.1727,0.4340 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'blinn' at graph 0.7497,0.4702 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'subdivision' at graph 0.4446,0.4619 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.5625,0.5004 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'isocurves' at graph 0.7712,0.7070 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7567,0.7951 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d6_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d6_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d6_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d6_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d6_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d6_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d6_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d6_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d6_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d6_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d6_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d6_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d6_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d6_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d6_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.68621:8285.73]
set yrange [0.00018859:62.7953]
set label 'tessellation' at graph 0.4977,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.7098,0.0446 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'kept' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'zsort' at graph 0.4383,0.2736 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2300,0.2795 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.8059,0.2857 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.0715,0.3015 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'mesa' at graph 0.4050,0.3121 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.1456,0.3424 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.4761,0.3665 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.3902,0.4176 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7622,0.6388 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6679,0.7563 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d7_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d7_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d7_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d7_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d7_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d7_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d7_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d7_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d7_8 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d7_9 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d7_10 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d7_11 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d7_12 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.271611:1587.52]
set yrange [0.000666432:34.4962]
set label 'tessellation' at graph 0.6683,0.0602 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.7475,0.0987 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'scanline' at graph 0.7576,0.1790 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.5559,0.2490 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.4172,0.2490 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'fd' at graph 0.2545,0.3115 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1730,0.3139 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3231 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.6212,0.3487 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4690,0.3487 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5318,0.4159 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7833,0.6164 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'kept' at graph 0.7715,0.6549 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7128,0.7011 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'voxels' at graph 0.8123,0.7415 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d8_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d8_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d8_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d8_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d8_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d8_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d8_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d8_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d8_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d8_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d8_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d8_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d8_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d8_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d8_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.17213:1630.62]
set yrange [0.000271944:24.1168]
set label 'kept' at graph 0.7178,0.1494 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.8270,0.2487 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'tessellation' at graph 0.5141,0.3022 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7356,0.2871 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3256 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2633,0.3789 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.7147,0.3929 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.2218,0.4174 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.5717,0.4492 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3430,0.4828 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5195,0.5260 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5776,0.4877 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7505,0.6810 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7710,0.7579 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7209,0.7981 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d9_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d9_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d9_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d9_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d9_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d9_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d9_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d9_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d9_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d9_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d9_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d9_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d9_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d9_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d9_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.15992:4055.08]
set yrange [0.000500557:54.666]
set label 'kept' at graph 0.7317,0.0802 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7818,0.1187 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1994 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7312,0.2380 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4516,0.3061 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.1886,0.3288 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2636,0.3348 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.6574,0.3344 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5453,0.3728 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5458,0.4113 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5225,0.4496 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2873,0.4484 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7688,0.6223 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7229,0.6957 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7497,0.7468 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d10_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d10_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d10_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d10_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d10_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d10_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d10_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d10_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d10_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d10_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d10_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d10_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d10_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d10_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d10_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.07737:1829.75]
set yrange [4.69261e-05:43.143]
set label 'whitted' at graph 0.8042,0.0446 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'kept' at graph 0.7095,0.2451 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'scanline' at graph 0.7375,0.3650 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4054 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5482,0.4140 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'lane-carpenter' at graph 0.7177,0.4543 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.2216,0.4620 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2782,0.4722 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5837,0.5016 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5447,0.4631 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5758,0.5399 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3370,0.5195 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7544,0.6960 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.6957,0.7513 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7322,0.7898 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d11_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d11_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d11_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d11_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d11_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d11_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d11_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d11_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d11_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d11_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d11_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d11_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d11_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d11_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d11_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.48643:3095.56]
set yrange [5.99821e-05:159.343]
set label 'whitted' at graph 0.7646,0.0446 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'kept' at graph 0.7270,0.1386 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'mesa' at graph 0.6189,0.2571 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7759,0.3059 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4967,0.3546 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3705,0.3510 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3838,0.3895 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3836 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.6588,0.4316 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5055,0.4386 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3329,0.4386 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7654,0.6147 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'lane-carpenter' at graph 0.7449,0.6532 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'voxels' at graph 0.7612,0.7971 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7352,0.8446 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d12_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d12_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d12_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d12_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d12_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d12_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d12_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d12_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d12_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d12_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d12_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d12_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d12_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d12_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d12_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.77845:3586.72]
set yrange [0.000347829:47.8989]
set label 'micropolygons' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'kept' at graph 0.7512,0.0254 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'mesa' at graph 0.6869,0.0639 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7594,0.2162 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4563,0.2432 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3107,0.2955 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3376,0.3338 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'zsort' at graph 0.4603,0.3608 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2897,0.3723 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.6205,0.3630 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.7175,0.5749 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'isocurves' at graph 0.7696,0.6373 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7133,0.6789 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7478,0.7508 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'whitted' at graph 0.6931,0.9073 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
plot $d13_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d13_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d13_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d13_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d13_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d13_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d13_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d13_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d13_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d13_9 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d13_10 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d13_11 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d13_12 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d13_13 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d13_14 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.46085:2868.52]
set yrange [7.66169e-05:36.2054]
set label 'kept' at graph 0.6631,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.8333,0.1068 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'tessellation' at graph 0.5318,0.1385 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.5798,0.2005 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3698,0.2005 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5049,0.2005 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'lane-carpenter' at graph 0.7094,0.3368 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.3719,0.3536 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3522,0.3920 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7666,0.3753 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5339,0.4902 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7420,0.6849 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7066,0.7660 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7330,0.9375 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
plot $d14_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d14_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d14_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d14_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d14_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d14_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d14_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d14_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d14_8 using 1:2 with linespoints lw 0.84 pt 8 ps 0.5 lc rgb '#c7a17a' notitle, \
     $d14_9 using 1:2 with linespoints lw 0.84 pt 14 ps 0.5 lc rgb '#a0522d' notitle, \
     $d14_10 using 1:2 with linespoints lw 0.84 pt 9 ps 0.5 lc rgb '#66c2a5' notitle, \
     $d14_11 using 1:2 with linespoints lw 0.84 pt 4 ps 0.5 lc rgb '#f4a6d7' notitle, \
     $d14_12 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d14_13 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset multiplot
set output
