# gnuplot error_time_all.gp
$d0_0 << end
0.641611 1.27649
0.658946 0.252355
0.711393 0.230083
0.873404 0.0760727
1.5567 0.0249165
2.32279 0.0118688
5.32954 0.00480035
end
$d0_1 << end
0.897089 0.460009
1.21854 0.21298
1.79957 0.10942
3.32337 0.0317154
5.52875 0.0126698
end
$d0_2 << end
9.2236 0.397744
15.7761 0.217819
35.1997 0.122641
76.9728 0.0487473
end
$d0_3 << end
1.58965 16
1.6846 11.3714
0.78922 2.09387
1.58199 0.621945
4.47745 0.140438
15.6008 0.0166913
47.9005 0.0050057
end
$d0_4 << end
3.66868 16
4.75556 11.3714
7.62764 2.09387
15.0863 0.621945
35.6575 0.140438
end
$d0_5 << end
1.62381 16
1.6577 11.3714
0.7967 2.09387
1.43117 0.621945
4.33329 0.140438
end
$d0_6 << end
66.7179 0.00543811
138.572 0.0136459
277.505 0.0136459
497.166 0.0136459
end
$d0_7 << end
40.7287 0.563902
113.851 0.638099
188.771 0.64648
333.872 0.664085
end
$d0_8 << end
235.587 0.140625
240.141 0.0318314
236.914 0.0114089
231.737 0.00626309
end
$d0_9 << end
71.9652 0.947749
148.72 0.947749
243.555 0.00777273
358.892 0.00160861
end
$d0_10 << end
186.079 16
185.128 16
185.284 16
188.519 16
end
$d0_11 << end
10.0223 0.518943
36.183 0.122641
86.5367 0.0418987
170.415 0.0226721
end
$d0_12 << end
21.5389 0.00246026
67.5343 0.00246026
125.602 0.00159003
400.68 0.00159003
end
$d0_13 << end
188.131 18.3987
220.072 8.87488
307.65 4.22956
502.296 2.51603
end
$d0_14 << end
17.6002 0.1836
23.9475 0.0747686
35.1034 0.0161339
65.887 0.0104229
end
$d1_0 << end
0.900023 0.756255
0.909288 0.477557
1.00056 0.177807
1.20758 0.106666
1.89382 0.0333622
3.00634 0.0199173
6.7485 0.00411116
end
$d1_1 << end
1.29243 0.376398
1.72109 0.166395
2.45757 0.0952735
4.89119 0.0327434
7.76117 0.0129553
end
$d1_2 << end
10.9368 0.482113
19.846 0.254077
35.2136 0.133274
90.156 0.0386115
end
$d1_3 << end
3.18104 16
3.34926 12.7659
3.10349 2.95896
1.46181 0.890052
3.76058 0.195142
12.4326 0.0726195
40.5398 0.0053543
end
$d1_4 << end
7.03636 16
8.35169 12.7659
11.9564 2.95896
22.309 0.890052
37.1164 0.195142
end
$d1_5 << end
3.2388 16
3.40604 12.7659
3.00364 2.95896
1.6304 0.890052
3.72577 0.195142
end
$d1_6 << end
133.915 0.012605
261.643 0.0124757
572.776 0.0124757
955.518 0.0124757
end
$d1_7 << end
79.3115 0.575845
224.287 0.666606
434.626 0.662536
682.365 0.662536
end
$d1_8 << end
395.984 0.148282
403.174 0.0282719
415.949 0.0123412
403.122 0.00602633
end
$d1_9 << end
106.418 0.0802299
207.368 0.0194055
346.58 0.00145289
end
$d1_10 << end
385.755 16
389.484 16
402.391 16
392.859 16
end
$d1_11 << end
13.0824 0.466252
43.4099 0.123617
104.823 0.0525195
201.34 0.020202
end
$d1_12 << end
43.4117 0.00974676
153.364 0.011339
785.109 0.00851493
2662.96 0.00109314
end
$d1_13 << end
261.087 33.8503
273.434 16.8807
338.076 8.23343
494.185 4.46822
end
$d1_14 << end
24.6341 0.237693
39.5516 0.0510987
55.0116 0.0348134
105.719 0.0103168
end
$d2_0 << end
1.3764 0.770465
1.30826 0.538295
1.38597 0.262023
1.73769 0.123842
2.75188 0.0577546
4.15432 0.0197638
9.44787 0.00405465
end
$d2_1 << end
1.59452 0.373918
2.00573 0.213234
2.83689 0.110943
5.07322 0.0448928
8.94245 0.0179569
end
$d2_2 << end
13.5034 0.614349
25.8974 0.338743
43.6486 0.150704
112.043 0.0586112
end
$d2_3 << end
2.85035 16
3.50056 7.54441
1.86985 1.70894
2.10717 0.621207
6.09578 0.150704
18.7584 0.0342275
65.7394 0.00456482
end
$d2_4 << end
5.8214 16
7.67962 7.54441
11.7891 1.70894
23.1221 0.621207
45.5721 0.150704
end
$d2_5 << end
2.78137 16
3.15511 7.54441
1.77524 1.70894
2.11425 0.621207
5.29366 0.150704
end
$d2_6 << end
130.059 0.0191395
268.194 0.00611559
574.5 0.00611559
1003.72 0.00611559
end
$d2_7 << end
79.9483 16
181.975 0.650576
359.79 0.615604
570.14 0.654771
end
$d2_8 << end
426.298 0.155623
447.46 0.0362423
475.311 0.0154842
443.755 0.00688986
end
$d2_9 << end
107.617 0.0966448
199.045 0.0212405
322.254 0.00357186
515.643 0.0021338
end
$d2_10 << end
351.277 16
350.611 16
349.02 16
359.735 16
end
$d2_11 << end
13.2018 0.522393
50.3189 0.150704
128.013 0.0460563
237.001 0.0238426
end
$d2_12 << end
58.2452 0.0040789
123.991 0.00202439
315.281 0.00172007
756.153 0.000235021
end
$d2_13 << end
208.463 28.5754
242.847 12.7753
297.876 6.42935
476.524 3.1763
end
$d2_14 << end
30.8154 0.150704
39.8613 0.0783722
78.7424 0.0302396
119.057 0.00987679
end
$d3_0 << end
0.436477 0.2601
0.406271 0.0882841
0.351851 0.0851007
0.768469 0.0284899
0.776641 0.006824
end
$d3_1 << end
0.374745 0.431997
0.280356 0.219752
0.352703 0.0715586
0.615962 0.0273808
0.945421 0.00676757
end
$d3_2 << end
1.16114 0.533865
2.09969 0.176084
3.95356 0.138867
8.83908 0.0422841
end
$d3_3 << end
0.444088 4.58154
0.203001 1.23118
0.260326 0.347362
0.596233 0.0912411
2.08075 0.0117177
7.51146 0.00319568
20.6179 0.000802636
end
$d3_4 << end
0.652978 4.58154
0.761679 1.23118
1.19359 0.347362
2.44956 0.0912411
6.51785 0.0117177
end
$d3_5 << end
0.473521 4.58154
0.226796 1.23118
0.309199 0.347362
0.699767 0.0912411
2.64521 0.0117177
end
$d3_6 << end
13.2462 0.0161666
26.7403 0.0161666
56.2979 0.0161666
98.3006 0.0161666
end
$d3_7 << end
9.61984 1.07474
24.4357 0.678558
37.7437 0.68419
58.3979 0.661954
end
$d3_8 << end
55.6539 0.125155
56.0208 0.0090866
58.1795 0.0090866
56.6422 0.00580957
end
$d3_9 << end
16.913 1.01292
55.3312 0.837628
140.122 0.00119441
end
$d3_10 << end
53.471 8.45753
51.4018 8.45753
54.6256 8.45753
54.9701 8.45753
end
$d3_11 << end
2.23663 0.488089
7.12715 0.100576
17.5599 0.0314993
33.3936 0.0206367
end
$d3_12 << end
5.47464 0.00110237
12.4473 0.000707021
23.2477 0.000902439
53.4269 0.00050257
end
$d3_13 << end
133.613 17.4516
162.477 8.2022
250.858 4.77779
408.346 1.89815
end
$d3_14 << end
3.68649 0.142958
3.80866 0.142958
5.41994 0.0585267
9.6138 0.0327248
end
$d4_0 << end
0.417209 0.294324
0.601932 0.117166
0.529615 0.0596952
0.616874 0.0316593
0.982856 0.00789777
end
$d4_1 << end
0.355417 0.214248
0.391199 0.134069
0.495765 0.0579277
0.659497 0.0206483
0.966192 0.0236108
end
$d4_2 << end
4.81583 0.676352
7.91019 0.19837
11.782 0.187711
24.8376 0.0236108
end
$d4_3 << end
1.91388 9.52545
1.53865 2.68703
1.17287 0.768625
0.947594 0.171573
2.69142 0.0417236
7.31098 0.01182
35.0993 0.00127221
end
$d4_4 << end
2.83737 9.52545
3.10184 2.68703
3.64007 0.768625
5.28851 0.171573
11.148 0.0417236
end
$d4_5 << end
1.19952 9.52545
0.974434 2.68703
0.732165 0.768625
0.652076 0.171573
1.84988 0.0417236
end
$d4_6 << end
40.4559 0.00646437
81.7039 0.00646437
170.145 0.00646437
291.944 0.00646437
end
$d4_7 << end
36.3261 16
64.2964 0.618896
110.076 0.636981
230.179 0.665414
end
$d4_8 << end
155.327 0.138234
149.012 0.0254922
end
$d4_9 << end
58.5922 1.07992
195.21 0.0047595
end
$d4_10 << end
159.943 16
146.485 16
151.75 16
148.151 16
end
$d4_11 << end
4.04808 0.657175
11.8942 0.136985
25.2074 0.0236108
48.1438 0.0236108
end
$d4_12 << end
14.7029 0.00143476
38.4012 0.00100023
85.809 0.00127221
377.408 0.00127221
end
$d4_13 << end
245.018 40.7916
278.163 17.1306
389.96 11.6081
667.62 4.71935
end
$d4_14 << end
6.23295 0.171573
7.06005 0.114541
8.60919 0.0592309
14.0608 0.0238257
end
$d5_0 << end
0.439441 0.246396
0.37796 0.176901
0.403307 0.0757754
0.565067 0.0280046
0.799184 0.0157699
end
$d5_1 << end
0.274446 0.286548
0.308457 0.217291
0.326905 0.0919876
0.432972 0.0458824
0.588763 0.0157699
end
$d5_2 << end
0.94511 0.821871
1.66165 0.339211
3.08264 0.197577
6.93833 0.0611845
end
$d5_3 << end
0.59352 6.82294
0.205515 1.17148
0.306945 0.405697
0.661821 0.084288
2.11198 0.0181551
7.78305 0.00405588
24.7469 0.00142208
end
$d5_4 << end
0.767878 6.82294
0.906433 1.17148
1.3764 0.405697
2.78538 0.084288
8.1649 0.0181551
end
$d5_5 << end
0.611516 6.82294
0.243882 1.17148
0.342097 0.405697
0.708821 0.084288
2.0954 0.0181551
end
$d5_6 << end
14.2767 0.016656
26.897 0.016656
53.975 0.016656
96.6865 0.016656
end
$d5_7 << end
9.9179 8.38636
22.9014 0.597742
37.8231 0.623981
57.1779 0.631364
end
$d5_8 << end
63.2719 0.153149
end
$d5_9 << end
17.118 0.0692598
52.3265 0.0146969
110.837 0.00113168
end
$d5_10 << end
60.7164 0.10559
60.5413 0.0178989
60.8841 0.00398946
60.3681 0.00165677
end
$d5_11 << end
1.42237 0.264942
5.32616 0.106448
11.5925 0.00142208
23.0892 0.00140997
end
$d5_12 << end
4.9345 0.000894179
11.3265 0.000763817
24.5166 0.00140997
39.7154 0.00140997
end
$d5_13 << end
104.035 13.7542
128.764 6.43314
182.932 3.23415
303.951 1.72338
end
$d5_14 << end
3.26069 0.274238
3.91532 0.103817
4.65366 0.084288
7.23657 0.0279317
end
$d6_0 << end
0.681489 0.437158
0.683873 0.0674436
0.695461 0.0674436
0.796269 0.0317614
1.08841 0.00888459
end
$d6_1 << end
0.74973 0.48735
0.840656 0.2075
0.970278 0.096966
1.82126 0.0436791
2.12158 0.0182582
end
$d6_2 << end
4.98142 0.478035
7.53083 0.214926
9.80137 0.110032
23.4271 0.0338142
end
$d6_3 << end
3.06056 2.34843
1.26141 0.851351
0.933303 0.214926
2.33569 0.0289812
7.43963 0.00639368
26.2643 0.000112701
81.8786 0.000112701
end
$d6_4 << end
5.3274 2.34843
9.30604 0.851351
13.2615 0.214926
14.5733 0.0289812
45.823 0.00639368
end
$d6_5 << end
3.01339 2.34843
0.880094 0.851351
0.891901 0.214926
2.18025 0.0289812
7.47345 0.00639368
end
$d6_6 << end
91.9795 0.0144088
183.071 0.0144088
396.423 0.0144088
632.452 0.0144088
end
$d6_7 << end
45.0949 0.61348
126.853 0.585633
276.056 0.600581
419.146 0.646489
end
$d6_8 << end
314.066 0.0114275
end
$d6_9 << end
80.5012 0.0293124
159.5 0.00789074
end
$d6_10 << end
315.871 0.0910757
299.498 0.0293124
end
$d6_11 << end
6.00077 0.404465
12.4684 0.128853
28.6279 0.317564
66.5962 0.0338142
end
$d6_12 << end
38.4285 0.000112701
103.749 0.000112701
194.259 0.000315848
326.624 0.000112701
end
$d6_13 << end
187.175 13.1394
188.133 6.30183
233.561 3.97103
347.916 2.04498
end
$d6_14 << end
15.4859 0.214926
15.4827 0.214926
20.6067 0.0531925
30.6541 0.0129983
end
$d7_0 << end
2.10369 0.102831
1.7159 0.0872668
1.75928 0.0872668
1.90551 0.0245429
2.43646 0.00872391
end
$d7_1 << end
1.35994 0.124749
1.42592 0.124749
1.98193 0.0486149
2.56662 0.0181237
3.56876 0.0146743
end
$d7_2 << end
8.0657 0.231083
9.632 0.142443
13.3878 0.0688788
27.8381 0.0381779
end
$d7_3 << end
4.91888 3.1378
5.39314 0.85607
2.32471 0.175312
2.25918 0.0381779
6.17681 0.00659181
20.1194 0.00213027
75.9185 0.000332701
end
$d7_4 << end
16.4489 3.1378
14.2474 0.85607
15.9059 0.175312
22.5628 0.0381779
59.4979 0.00659181
end
$d7_5 << end
4.94402 3.1378
5.25019 0.85607
2.06545 0.175312
2.31423 0.0381779
6.03266 0.00659181
end
$d7_6 << end
175.46 0.00731614
385.512 0.00713256
920.933 0.00713256
1326.77 0.00713256
end
$d7_7 << end
99.85 0.602107
286.399 0.616223
695.609 0.616223
928.277 0.635802
end
$d7_8 << end
548.283 0.000332701
570.957 0.000332701
588.188 0.000332701
568.333 0.000332701
end
$d7_9 << end
8.87746 0.483683
16.0858 0.0769085
30.4057 0.0381779
64.9944 0.0199344
end
$d7_10 << end
54.4947 0.000332701
201.327 0.000332701
424.339 0.000332701
1492.05 0.000332701
end
$d7_11 << end
214.363 28.3646
224.48 11.8414
267.441 6.16002
372.579 2.83254
end
$d7_12 << end
22.6736 0.0868215
29.6593 0.0381779
27.6177 0.0231854
33.9844 0.00926024
end
$d8_0 << end
0.572558 0.409218
0.835118 0.130562
0.80299 0.134721
0.84344 0.0377867
1.3905 0.0201101
end
$d8_1 << end
0.691835 0.474817
0.885171 0.191897
1.13113 0.1043
1.91354 0.0457064
2.83754 0.0195869
end
$d8_2 << end
5.18994 0.453333
7.60632 0.377984
13.8225 0.103518
28.5176 0.0608294
end
$d8_3 << end
1.32384 2.44984
0.443877 0.639867
0.898501 0.194376
2.607 0.037334
8.80789 0.00994697
44.4659 0.00248462
88.3912 0.00129747
end
$d8_4 << end
3.90379 2.44984
3.42637 0.639867
4.60955 0.194376
10.9873 0.037334
33.6988 0.00994697
end
$d8_5 << end
1.27462 2.44984
0.438089 0.639867
1.35153 0.194376
2.55403 0.037334
11.3209 0.00994697
end
$d8_6 << end
53.8976 0.0340913
134.343 0.0222283
246.019 0.0222283
390.464 0.0222283
end
$d8_7 << end
34.9783 0.65172
101.424 0.624137
154.207 0.649739
318.336 0.643614
end
$d8_8 << end
203.861 0.169863
222.73 0.0369673
216.321 0.0106697
223.299 0.00465298
end
$d8_9 << end
41.6472 0.769102
69.0902 0.769102
87.7695 0.769102
143.619 1.345
end
$d8_10 << end
185.429 0.103563
187.602 0.00931606
187.221 0.00697734
183.73 0.00191904
end
$d8_11 << end
5.00588 0.547824
13.8778 0.10052
32.6028 0.0521723
63.4623 0.0293478
end
$d8_12 << end
20.8909 0.00108194
61.1867 0.678551
116.146 0.666698
186.855 0.678551
end
$d8_13 << end
203.263 17.5043
202.164 9.07526
234.338 4.65613
342.301 2.08489
end
$d8_14 << end
8.72688 0.194376
11.0962 0.0795511
14.2489 0.0795511
16.2583 0.0293478
end
$d9_0 << end
3.16764 0.496405
3.58337 0.128249
5.40772 0.127776
6.63212 0.0499481
8.02357 0.0275697
end
$d9_1 << end
4.21026 0.685299
3.9461 0.213831
4.73698 0.118751
7.36455 0.0635638
8.6241 0.0233497
end
$d9_2 << end
9.99515 0.495956
19.2863 0.286077
34.6078 0.150413
80.8503 0.0784139
end
$d9_3 << end
2.32512 3.12366
1.93017 0.836907
5.652 0.247131
15.1073 0.0665993
48.5371 0.00850119
end
$d9_4 << end
5.51374 3.12366
9.27814 0.836907
24.3465 0.247131
75.6658 0.0665993
end
$d9_5 << end
1.87605 3.12366
1.46637 0.836907
4.60025 0.247131
17.4094 0.0665993
end
$d9_6 << end
72.9867 0.0202976
150.924 0.00876149
319.117 0.00876149
551.358 0.00876149
end
$d9_7 << end
55.7137 1.81597
106.636 0.601578
193.605 0.675885
315.608 0.636386
end
$d9_8 << end
245.355 0.149426
244.965 0.0360529
277.797 0.0157577
258.997 0.00862334
end
$d9_9 << end
92.7258 0.0822869
179.748 0.02223
275.415 0.00543481
450.457 0.00486266
end
$d9_10 << end
191.689 2.41669
207.884 2.41669
202.962 2.41669
214.589 2.41669
end
$d9_11 << end
14.1432 0.387375
46.945 0.107193
108.014 0.0487828
232.826 0.0239044
end
$d9_12 << end
23.8623 0.0120119
65.789 0.0011598
116.363 0.000452236
215.812 0.00149167
end
$d9_13 << end
136.564 11.8326
159.432 7.44346
211.109 3.33876
321.279 1.52939
end
$d9_14 << end
23.6792 0.256166
24.1236 0.256166
36.2164 0.0848854
50.7282 0.0665993
end
$d10_0 << end
3.14529 0.263987
3.48989 0.242959
3.8243 0.143692
5.69312 0.0528481
7.16993 0.0226918
end
$d10_1 << end
4.35939 0.543688
5.37282 0.276982
6.24006 0.120338
8.3969 0.0516379
11.22 0.024345
end
$d10_2 << end
12.577 0.473492
22.7817 0.192967
40.7396 0.148114
106.37 0.0438457
end
$d10_3 << end
3.76505 5.28405
2.38301 1.3061
4.84995 0.383861
14.623 0.0909569
50.096 0.0174457
end
$d10_4 << end
9.51311 5.28405
15.7294 1.3061
27.1365 0.383861
84.9333 0.0909569
end
$d10_5 << end
3.40675 5.28405
1.72411 1.3061
4.06405 0.383861
14.9203 0.0909569
end
$d10_6 << end
153.637 0.00911068
334.362 0.00321158
691.47 0.00506085
1170.36 0.00506085
end
$d10_7 << end
88.673 0.628235
241.948 0.610583
394.641 0.628481
672.633 0.683871
end
$d10_8 << end
480.286 0.15301
507.63 0.0380473
467.52 0.0123264
466.306 0.00791634
end
$d10_9 << end
154.25 0.0959039
290.22 0.0199104
473.99 0.00803893
671.352 0.00198377
end
$d10_10 << end
410.256 1.60116
421.636 1.60116
425.032 1.60116
420.213 1.60116
end
$d10_11 << end
14.8058 0.481089
52.6763 0.10186
135.598 0.0438457
262.352 0.0268417
end
$d10_12 << end
48.3523 0.000840187
129.181 0.00149918
449.149 0.00126979
end
$d10_13 << end
229.716 26.4744
271.895 13.0583
361.653 6.64838
536.445 2.89832
end
$d10_14 << end
33.5507 0.383861
45.3825 0.234303
60.6519 0.0909569
97.5843 0.0466781
end
$d11_0 << end
2.97283 0.345056
2.9913 0.159376
4.36598 0.106179
4.11856 0.0523258
5.83739 0.0267119
end
$d11_1 << end
3.19204 0.491808
3.33693 0.310184
4.37864 0.126328
6.13397 0.054526
7.35319 0.0307251
end
$d11_2 << end
10.191 0.614287
18.6419 0.355659
35.8242 0.109309
83.3968 0.0404731
end
$d11_3 << end
2.0583 3.65155
1.5725 1.04791
4.57877 0.288699
13.2754 0.0587762
46.9923 0.0138196
end
$d11_4 << end
6.26305 3.65155
9.39928 1.04791
24.7071 0.288699
70.2262 0.0587762
end
$d11_5 << end
2.09424 3.65155
1.42878 1.04791
4.53828 0.288699
13.4392 0.0587762
end
$d11_6 << end
75.0482 0.012271
146.433 0.012271
289.855 0.012271
513.122 0.012271
end
$d11_7 << end
39.6037 0.620711
105.003 0.624
172.75 0.675235
308.56 0.664088
end
$d11_8 << end
231.062 0.155599
232.084 0.0409791
240.643 0.0164609
238.657 0.00705221
end
$d11_9 << end
86.4797 0.112191
167.79 0.0275975
263.353 0.00812331
416.125 8.66248e-05
end
$d11_10 << end
188.015 1.51534
183.702 1.51534
188.595 1.51534
187.839 1.51534
end
$d11_11 << end
12.9158 0.481956
46.734 0.109309
104.376 0.054526
235.231 0.0242105
end
$d11_12 << end
28.7259 0.00561576
71.8505 0.00230231
128.068 0.00124907
210.487 0.00135887
end
$d11_13 << end
135.285 18.2891
139.14 8.98901
175.439 4.50026
259.57 2.254
end
$d11_14 << end
21.4915 0.288699
23.9767 0.288699
34.01 0.0929819
63.0169 0.0404731
end
$d12_0 << end
12.8001 0.242011
13.0769 0.152234
16.0784 0.0694318
19.0228 0.0298556
23.5641 0.0143453
end
$d12_1 << end
12.5318 0.381005
12.1381 0.242011
15.9133 0.0834074
22.1205 0.0437911
30.2173 0.0143453
end
$d12_2 << end
35.3234 0.578935
54.8572 0.337727
96.0648 0.138599
226.548 0.035524
end
$d12_3 << end
2.90045 0.969862
6.59209 0.211598
19.9692 0.0394482
62.1747 0.0113739
end
$d12_4 << end
10.193 0.969862
24.2558 0.211598
76.2956 0.0394482
end
$d12_5 << end
1.97215 0.969862
5.36617 0.211598
19.1733 0.0394482
end
$d12_6 << end
150.9 0.0357932
271.457 0.0174715
509.073 0.0174715
865.214 0.0174715
end
$d12_7 << end
104.396 16
221.257 0.54363
417.497 0.598398
586.126 0.63027
end
$d12_8 << end
555.616 0.132094
641.019 0.0285002
587.625 0.00955743
597.057 0.00553949
end
$d12_9 << end
119.449 16
235.325 0.0171948
333.77 0.00447538
483.61 0.000116097
end
$d12_10 << end
410.137 16
402.429 16
414.552 16
414.677 16
end
$d12_11 << end
25.9603 16
90.155 16
218.147 16
426.467 0.798322
end
$d12_12 << end
47.7922 0.000466313
114.285 0.000466313
219.676 0.000466313
344.837 0.000466313
end
$d12_13 << end
258.332 63.2139
285.094 45.5494
333.67 17.2114
513.869 7.91942
end
$d12_14 << end
63.5917 0.0394482
62.1664 0.0394482
96.1536 0.012691
142.382 0.00268785
end
$d13_0 << end
9.02297 0.268983
10.9527 0.174134
11.6566 0.102036
13.7838 0.0242444
18.2943 0.0138848
end
$d13_1 << end
9.6362 0.345527
11.7975 0.298992
12.743 0.115417
19.6442 0.0446806
24.5728 0.0171081
end
$d13_2 << end
28.1551 0.424949
50.5884 0.230491
89.2029 0.103092
201.438 0.0255139
end
$d13_3 << end
3.451 0.775775
6.19549 0.158495
18.5874 0.024857
57.9592 0.00618285
end
$d13_4 << end
9.60721 0.775775
20.507 0.158495
59.4912 0.024857
end
$d13_5 << end
2.50074 0.775775
5.02541 0.158495
17.5232 0.024857
end
$d13_6 << end
176.877 0.0138848
343.553 0.000589907
638.263 0.000589907
1042.02 0.000589907
end
$d13_7 << end
97.4088 16
230.214 0.627358
399.952 0.687581
607.888 0.654962
end
$d13_8 << end
596.623 0.154575
568.192 0.0292246
587.495 0.0152017
572.416 0.0044893
end
$d13_9 << end
94.047 0.334281
161.016 16
234.677 16
344.531 16
end
$d13_10 << end
395.18 16
394.891 11.0932
396.442 1.07145
398.775 1.07145
end
$d13_11 << end
22.4483 16
80.0203 16
202.275 0.0255139
398.761 0.313017
end
$d13_12 << end
52.5078 0.00180089
139.457 0.00180089
254.765 16
432.173 0.000589907
end
$d13_13 << end
365.646 22.8634
346.455 10.5501
374.73 6.13612
538.461 2.50865
end
$d13_14 << end
52.1072 0.024857
83.9409 0.00914146
118.051 0.00618285
288.476 0.000589907
end
$d14_0 << end
11.6921 0.147679
17.5416 0.0723985
15.9262 0.0338369
17.871 0.0177094
23.751 0.00999439
end
$d14_1 << end
12.3976 0.470219
15.4955 0.24068
15.0579 0.050068
17.4993 0.0177094
20.7927 0.00999439
end
$d14_2 << end
15.987 0.405303
23.3218 0.314287
38.1698 0.0958438
87.4361 0.0463156
end
$d14_3 << end
3.91632 0.0919171
10.6277 0.0141345
24.9848 0.00105269
81.5862 0.000467914
end
$d14_4 << end
10.3335 0.0919171
28.7516 0.0141345
95.449 0.00105269
end
$d14_5 << end
1.96593 0.0919171
6.36332 0.0141345
24.7478 0.00105269
end
$d14_6 << end
58.1143 0.00999439
140.769 0.00999439
260.468 0.00999439
474.493 0.00999439
end
$d14_7 << end
70.941 0.582201
158.448 0.549583
298.373 0.58987
384.175 0.58987
end
$d14_8 << end
137.629 0.993697
284.928 0.774162
485.683 0.00999439
736.898 0.00030911
end
$d14_9 << end
364.948 16
367.805 16
370.074 16
end
$d14_10 << end
19.8703 0.2045
66.8679 1.03321
154.596 0.0141345
307.363 0.00645517
end
$d14_11 << end
30.8882 0.00105269
64.1654 0.122034
122.961 0.00030911
209.143 0.000137293
end
$d14_12 << end
132.244 15.339
151.47 7.50831
206.866 3.68713
310.141 1.70252
end
$d14_13 << end
31.5122 0.0141345
27.0098 0.0141345
26.9745 0.0141345
60.9226 0.00105269
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
set xrange [0.45982:2035.33]
set yrange [0.000995947:35.418]
set label 'kept' at graph 0.8064,0.0200 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7933,0.0769 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2919,0.1501 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5534,0.1341 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7412,0.1909 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5914,0.2241 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2962,0.2427 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8321,0.2479 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.7046,0.3047 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.6099,0.3713 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5182,0.4723 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2672,0.4723 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7847,0.6205 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7476 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7166,0.9242 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.603529:14265.9]
set yrange [0.000651826:69.8111]
set label 'kept' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.6309,0.0692 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2397,0.1590 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.4178,0.1817 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.6459,0.1887 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5130,0.2386 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.7316,0.2455 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2536,0.2581 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.5769,0.3024 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.4971,0.3592 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4090,0.4923 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.1807,0.4923 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.6981,0.5979 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6661,0.7627 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6433,0.8728 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.93853:4049.91]
set yrange [0.000130877:64.8536]
set label 'kept' at graph 0.7995,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7538,0.2126 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2759,0.2618 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5077,0.2709 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2694 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7358,0.3263 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5786,0.3297 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2693,0.3753 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.6609,0.3969 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5714,0.4655 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4639,0.5375 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2067,0.5375 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7658,0.6495 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7443,0.7700 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7107,0.8933 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.138778:2017.3]
set yrange [0.000297965:36.2811]
set label 'kept' at graph 0.6211,0.0257 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'tessellation' at graph 0.5218,0.0827 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'whitted' at graph 0.7217,0.1395 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'scanline' at graph 0.6272,0.2537 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'fd' at graph 0.2002,0.2386 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1797,0.2955 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.4016,0.2794 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3075,0.3361 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.6847,0.3196 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.5721,0.3765 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4422,0.3931 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4334,0.4499 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.6304,0.6581 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7480 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6241,0.8756 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.243808:3251.06]
set yrange [0.00058827:85.7637]
set label 'tessellation' at graph 0.5232,0.0649 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'kept' at graph 0.7733,0.0649 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7039,0.1602 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'micropolygons' at graph 0.7462,0.2172 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.1468,0.2184 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1450,0.3105 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4868,0.2499 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.5565,0.3637 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4269,0.3153 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.6754,0.3068 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.4025,0.3722 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2134,0.3584 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7212,0.5913 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7561 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6748,0.8588 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.142674:1407.65]
set yrange [0.000467969:27.3097]
set label 'whitted' at graph 0.7236,0.0313 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'lane-carpenter' at graph 0.5531,0.2020 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'kept' at graph 0.6120,0.0313 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'tessellation' at graph 0.5606,0.1451 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.6576,0.0882 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'afd' at graph 0.1873,0.2920 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1541,0.3490 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7088,0.3255 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'zsort' at graph 0.4400,0.3245 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2922,0.3289 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.4269,0.3859 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4223,0.4441 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'scanline' at graph 0.6627,0.5277 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'isocurves' at graph 0.6517,0.6567 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
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
set xrange [0.484262:2655.93]
set yrange [6.2892e-05:29.7331]
set label 'tessellation' at graph 0.5959,0.0200 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'kept' at graph 0.7566,0.0768 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'zsort' at graph 0.5285,0.3394 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3178,0.3537 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'whitted' at graph 0.6733,0.3325 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.0941,0.3780 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'scanline' at graph 0.7520,0.3892 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.4818,0.3962 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4462 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.1716,0.4349 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'blinn' at graph 0.7465,0.5115 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'subdivision' at graph 0.4505,0.5100 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.5719,0.4532 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'isocurves' at graph 0.7856,0.7070 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7639,0.7951 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [0.958311:6489.91]
set yrange [0.00018859:62.7953]
set label 'tessellation' at graph 0.4957,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.7239,0.0446 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'kept' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'zsort' at graph 0.4681,0.2572 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2086,0.2795 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.8200,0.2857 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.1058,0.2935 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'mesa' at graph 0.4046,0.3140 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.1491,0.3505 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.4781,0.3709 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.3819,0.4278 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7795,0.6388 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6760,0.7563 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [0.311933:1625.87]
set yrange [0.000666432:34.4962]
set label 'tessellation' at graph 0.6598,0.0509 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.7453,0.1079 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'scanline' at graph 0.7680,0.1790 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.5471,0.2206 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.4196,0.2775 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'fd' at graph 0.2580,0.3115 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1746,0.3139 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3057 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.6210,0.3625 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4619,0.3487 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5276,0.4195 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.8095,0.5932 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'kept' at graph 0.7472,0.6500 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7165,0.7069 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'voxels' at graph 0.8180,0.7638 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [1.09014:1915.24]
set yrange [0.000271944:24.1168]
set label 'kept' at graph 0.7078,0.1494 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.8063,0.2283 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'tessellation' at graph 0.5081,0.3022 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7322,0.3420 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2851 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2768,0.3696 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.7179,0.3988 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.2672,0.4266 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.5675,0.4307 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3708,0.4828 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5140,0.5444 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5764,0.4877 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7587,0.6810 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7610,0.7495 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7070,0.8065 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [1.24445:4602.44]
set yrange [0.000500557:54.666]
set label 'kept' at graph 0.7168,0.0710 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7657,0.1280 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1902 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7213,0.2472 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4498,0.2901 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.2132,0.3033 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2677,0.3603 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.6513,0.3470 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5414,0.4124 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5309,0.3555 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5140,0.4693 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3024,0.4484 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7659,0.6223 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7087,0.6928 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7384,0.7497 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [1.06464:1765.32]
set yrange [4.69261e-05:43.143]
set label 'whitted' at graph 0.8051,0.0446 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'kept' at graph 0.7131,0.2451 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'scanline' at graph 0.7301,0.3489 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4058 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5109,0.3962 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'lane-carpenter' at graph 0.7281,0.4629 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.2295,0.4386 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2607,0.4956 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5883,0.5667 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5505,0.4530 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5651,0.5099 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3420,0.5195 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7647,0.6889 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.6978,0.7457 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7414,0.8026 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [1.45489:3104.43]
set yrange [5.99821e-05:159.343]
set label 'whitted' at graph 0.7574,0.0446 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'kept' at graph 0.7133,0.1386 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'mesa' at graph 0.5979,0.2571 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7849,0.3059 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4898,0.3546 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3633,0.3362 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3957,0.3930 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3791 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.6585,0.4361 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5165,0.4386 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3364,0.4500 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7825,0.6055 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'lane-carpenter' at graph 0.7410,0.6625 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'voxels' at graph 0.7654,0.7924 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7374,0.8493 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [1.8496:3698.59]
set yrange [0.000347829:47.8989]
set label 'micropolygons' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'kept' at graph 0.7175,0.0200 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'mesa' at graph 0.6644,0.0768 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7545,0.2162 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4532,0.2432 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3015,0.2770 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3403,0.3339 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'zsort' at graph 0.4566,0.3608 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2958,0.3907 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.6171,0.3630 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.7070,0.5735 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'isocurves' at graph 0.7624,0.6303 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7070,0.6872 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7465,0.7508 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'whitted' at graph 0.6877,0.9073 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
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
set xrange [1.46176:2558.08]
set yrange [7.66169e-05:36.2054]
set label 'kept' at graph 0.6647,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.8333,0.1068 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'tessellation' at graph 0.5386,0.1268 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.5596,0.1838 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3789,0.1863 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.4995,0.2433 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'lane-carpenter' at graph 0.7162,0.3276 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.3734,0.3443 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3555,0.4013 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7744,0.3846 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5479,0.4902 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7461,0.6849 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7174,0.7660 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7411,0.9375 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.45982:2035.33]
set yrange [0.000995947:35.418]
set label 'kept' at graph 0.8064,0.0260 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7933,0.0644 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2919,0.1501 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5534,0.1541 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7412,0.1755 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5914,0.2241 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2962,0.2427 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8321,0.2498 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.7046,0.2982 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.6099,0.3713 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5182,0.4723 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2672,0.4723 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7847,0.6205 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7476 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7166,0.9242 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.603529:14265.9]
set yrange [0.000651826:69.8111]
set label 'kept' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.6309,0.0692 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2397,0.1590 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.4178,0.1818 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.6459,0.1920 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5130,0.2385 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.7316,0.2549 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2536,0.2581 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.5769,0.2965 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.4971,0.3524 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4090,0.4923 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.1807,0.4923 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.6981,0.5979 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6661,0.7627 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6433,0.8728 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.93853:4049.91]
set yrange [0.000130877:64.8536]
set label 'kept' at graph 0.7995,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7538,0.2129 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2759,0.2618 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5077,0.2709 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2785 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7358,0.3169 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5786,0.3297 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2693,0.3753 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.6609,0.3969 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5714,0.4655 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4639,0.5375 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2067,0.5375 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7658,0.6495 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7443,0.7700 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7107,0.8933 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.138778:2017.3]
set yrange [0.000297965:36.2811]
set label 'kept' at graph 0.6211,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'tessellation' at graph 0.5218,0.0846 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'whitted' at graph 0.7217,0.1186 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'scanline' at graph 0.6272,0.2537 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'fd' at graph 0.2002,0.2478 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1797,0.2863 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.4016,0.2943 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3075,0.3328 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.6847,0.3322 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.5721,0.3707 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4422,0.3930 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4334,0.4315 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.6304,0.6581 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7480 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6241,0.8756 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.243808:3251.06]
set yrange [0.00058827:85.7637]
set label 'tessellation' at graph 0.5232,0.0649 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'kept' at graph 0.7733,0.0649 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7039,0.1695 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'micropolygons' at graph 0.7462,0.2080 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.1468,0.2184 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1450,0.3105 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4868,0.2819 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.5565,0.3426 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4269,0.3204 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.6754,0.3041 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.4025,0.3587 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2134,0.3584 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7212,0.5913 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7561 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.6748,0.8588 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.142674:1407.65]
set yrange [0.000467969:27.3097]
set label 'whitted' at graph 0.7236,0.0536 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'lane-carpenter' at graph 0.5531,0.1687 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'kept' at graph 0.6120,0.0535 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'tessellation' at graph 0.5606,0.1303 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.6576,0.0919 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'afd' at graph 0.1873,0.3013 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1541,0.3398 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7088,0.3255 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'zsort' at graph 0.4400,0.3334 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2922,0.3334 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.4269,0.3726 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4223,0.4441 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'scanline' at graph 0.6627,0.5277 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'isocurves' at graph 0.6517,0.6567 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
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
set xrange [0.484262:2655.93]
set yrange [6.2892e-05:29.7331]
set label 'tessellation' at graph 0.5959,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'kept' at graph 0.7566,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'zsort' at graph 0.5285,0.3537 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3178,0.3537 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'whitted' at graph 0.6733,0.3562 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.0941,0.3789 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'scanline' at graph 0.7520,0.3946 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.4818,0.4080 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4330 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.1716,0.4340 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'blinn' at graph 0.7465,0.4702 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'subdivision' at graph 0.4505,0.4619 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.5719,0.5004 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'isocurves' at graph 0.7856,0.7070 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7639,0.7951 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [0.958311:6489.91]
set yrange [0.00018859:62.7953]
set label 'tessellation' at graph 0.4957,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.7239,0.0446 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'kept' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'zsort' at graph 0.4681,0.2736 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2086,0.2795 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.8200,0.2857 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.1058,0.3015 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'mesa' at graph 0.4046,0.3121 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.1491,0.3424 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.4781,0.3665 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.3819,0.4176 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7795,0.6388 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6760,0.7563 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [0.311933:1625.87]
set yrange [0.000666432:34.4962]
set label 'tessellation' at graph 0.6598,0.0602 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'blinn' at graph 0.7453,0.0987 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'scanline' at graph 0.7680,0.1790 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.5471,0.2490 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.4196,0.2490 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'fd' at graph 0.2580,0.3115 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1746,0.3139 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3231 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.6210,0.3487 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'mesa' at graph 0.4619,0.3487 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5276,0.4159 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.8095,0.6164 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'kept' at graph 0.7472,0.6549 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7165,0.7011 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'voxels' at graph 0.8180,0.7415 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [1.09014:1915.24]
set yrange [0.000271944:24.1168]
set label 'kept' at graph 0.7078,0.1494 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.8063,0.2487 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'tessellation' at graph 0.5081,0.3022 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7322,0.2871 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3256 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2768,0.3789 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.7179,0.3929 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.2672,0.4174 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.5675,0.4492 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3708,0.4828 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5140,0.5260 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5764,0.4877 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7587,0.6810 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7610,0.7579 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7070,0.7981 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [1.24445:4602.44]
set yrange [0.000500557:54.666]
set label 'kept' at graph 0.7168,0.0802 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7657,0.1187 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1994 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7213,0.2380 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4498,0.3061 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.2132,0.3288 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2677,0.3348 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'lane-carpenter' at graph 0.6513,0.3344 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5414,0.3728 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5309,0.4113 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5140,0.4496 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3024,0.4484 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7659,0.6223 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7087,0.6957 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7384,0.7468 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [1.06464:1765.32]
set yrange [4.69261e-05:43.143]
set label 'whitted' at graph 0.8051,0.0446 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'kept' at graph 0.7131,0.2451 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'scanline' at graph 0.7301,0.3650 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4054 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5109,0.4140 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'lane-carpenter' at graph 0.7281,0.4543 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.2295,0.4479 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2607,0.4864 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5883,0.5016 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5505,0.4631 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5651,0.5399 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3420,0.5195 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7647,0.6960 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.6978,0.7513 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7414,0.7898 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [1.45489:3104.43]
set yrange [5.99821e-05:159.343]
set label 'whitted' at graph 0.7574,0.0446 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'kept' at graph 0.7133,0.1386 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'mesa' at graph 0.5979,0.2571 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7849,0.3059 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4898,0.3546 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3633,0.3510 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3957,0.3895 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3836 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.6585,0.4316 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5165,0.4386 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3364,0.4386 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7825,0.6147 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'lane-carpenter' at graph 0.7410,0.6532 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'voxels' at graph 0.7654,0.7971 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7374,0.8446 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [1.8496:3698.59]
set yrange [0.000347829:47.8989]
set label 'micropolygons' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'kept' at graph 0.7175,0.0254 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'mesa' at graph 0.6644,0.0639 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7545,0.2162 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4532,0.2432 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3015,0.2955 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3403,0.3338 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'zsort' at graph 0.4566,0.3608 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2958,0.3723 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.6171,0.3630 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'lane-carpenter' at graph 0.7070,0.5749 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'isocurves' at graph 0.7624,0.6373 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7070,0.6789 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.7465,0.7508 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'whitted' at graph 0.6877,0.9073 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
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
set xrange [1.46176:2558.08]
set yrange [7.66169e-05:36.2054]
set label 'kept' at graph 0.6647,0.0446 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.8333,0.1068 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'tessellation' at graph 0.5386,0.1385 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.5596,0.1813 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3789,0.2005 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.4995,0.2198 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'lane-carpenter' at graph 0.7162,0.3368 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'afd' at graph 0.3734,0.3536 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3555,0.3920 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7744,0.3753 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5479,0.4902 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7461,0.6849 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7174,0.7660 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7411,0.9375 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
