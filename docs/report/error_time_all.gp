# gnuplot error_time_all.gp
$d0_0 << end
0.88365 1.27649
1.11304 0.252355
1.16831 0.230083
1.2576 0.0760727
2.05438 0.0249165
3.30137 0.0118688
7.15848 0.00480035
end
$d0_1 << end
1.78214 0.460009
1.80122 0.21298
3.17685 0.10942
3.91762 0.0317154
6.519 0.0126698
end
$d0_2 << end
9.7177 0.397744
16.4802 0.217819
32.0026 0.122641
79.3531 0.0487473
end
$d0_3 << end
2.05557 16
2.8908 11.3714
1.01536 2.09387
1.98568 0.621945
5.16662 0.140438
19.8505 0.0166913
59.7471 0.0050057
end
$d0_4 << end
4.34812 16
5.76753 11.3714
8.29715 2.09387
15.5941 0.621945
35.8365 0.140438
end
$d0_5 << end
1.73906 16
1.80376 11.3714
0.858893 2.09387
1.55308 0.621945
4.95652 0.140438
end
$d0_6 << end
71.9894 0.00543811
155.952 0.0136459
294.813 0.0136459
534.642 0.0136459
end
$d0_7 << end
43.2417 0.563902
112.35 0.638099
244.152 0.64648
367.287 0.664085
end
$d0_8 << end
241.45 0.140625
240.136 0.0318314
245.891 0.0114089
264.03 0.00626309
end
$d0_9 << end
191.749 18.3987
236.095 8.87488
324.844 4.22956
526.251 2.51603
end
$d0_10 << end
21.6105 0.1836
31.0636 0.0747686
55.436 0.0161339
92.7131 0.0104229
end
$d1_0 << end
1.75497 0.756255
1.96512 0.477557
1.52812 0.177807
2.6221 0.106666
3.55426 0.0333622
4.99743 0.0199173
9.81391 0.00411116
end
$d1_1 << end
2.00922 0.376398
2.84286 0.166395
4.11353 0.0952735
4.9384 0.0327434
9.16153 0.0129553
end
$d1_2 << end
11.7801 0.482113
21.4223 0.254077
36.7779 0.133274
94.8668 0.0386115
end
$d1_3 << end
4.0751 16
5.98251 12.7659
4.16142 2.95896
1.84468 0.890052
5.53735 0.195142
15.0692 0.0726195
46.2007 0.0053543
end
$d1_4 << end
7.48725 16
8.68415 12.7659
12.4953 2.95896
22.7262 0.890052
47.0922 0.195142
end
$d1_5 << end
3.28137 16
3.49859 12.7659
3.12838 2.95896
1.59063 0.890052
4.46043 0.195142
end
$d1_6 << end
144.901 0.012605
295.582 0.0124757
708.436 0.0124757
1072.4 0.0124757
end
$d1_7 << end
87.5216 0.575845
243.621 0.666606
512.495 0.662536
729.829 0.662536
end
$d1_8 << end
426.141 0.148282
425.603 0.0282719
440.493 0.0123412
421.928 0.00602633
end
$d1_9 << end
261.437 33.8503
277.755 16.8807
348.203 8.23343
524.53 4.46822
end
$d1_10 << end
27.5059 0.237693
41.6089 0.0510987
66.838 0.0348134
113.548 0.0103168
end
$d2_0 << end
2.71712 0.770465
1.59931 0.538295
2.38722 0.262023
1.81316 0.123842
2.83241 0.0577546
4.82239 0.0197638
9.99926 0.00405465
end
$d2_1 << end
2.23589 0.373918
2.14679 0.213234
3.72433 0.110943
5.60444 0.0448928
9.08255 0.0179569
end
$d2_2 << end
14.6324 0.614349
26.2614 0.338743
47.4936 0.150704
119.19 0.0586112
end
$d2_3 << end
3.73409 16
5.35297 7.54441
2.14149 1.70894
3.20164 0.621207
6.46717 0.150704
21.0238 0.0342275
67.5698 0.00456482
end
$d2_4 << end
5.94751 16
7.94274 7.54441
11.9673 1.70894
20.3863 0.621207
50.0557 0.150704
end
$d2_5 << end
3.00642 16
3.53565 7.54441
1.79417 1.70894
2.97084 0.621207
8.34935 0.150704
end
$d2_6 << end
131.756 0.0191395
280.125 0.00611559
549.374 0.00611559
926.681 0.00611559
end
$d2_7 << end
74.8976 16
184.799 0.650576
355.864 0.615604
512.725 0.654771
end
$d2_8 << end
425.125 0.155623
424.177 0.0362423
419.74 0.0154842
421.467 0.00688986
end
$d2_9 << end
215.984 28.5754
247.094 12.7753
337.83 6.42935
451.092 3.1763
end
$d2_10 << end
30.4508 0.150704
41.9473 0.0783722
55.9995 0.0302396
106.132 0.00987679
end
$d3_0 << end
0.314586 0.2601
0.31719 0.0882841
0.336289 0.0851007
0.462485 0.0284899
0.622873 0.006824
end
$d3_1 << end
0.254837 0.431997
0.27666 0.219752
0.305722 0.0715586
0.413753 0.0273808
0.554491 0.00676757
end
$d3_2 << end
1.19266 0.533865
2.24647 0.176084
3.87244 0.138867
8.67079 0.0422841
end
$d3_3 << end
0.430158 4.58154
0.181218 1.23118
0.263971 0.347362
0.593539 0.0912411
1.95766 0.0117177
7.52857 0.00319568
22.0566 0.000802636
end
$d3_4 << end
0.678055 4.58154
0.886794 1.23118
1.15976 0.347362
2.36962 0.0912411
6.51952 0.0117177
end
$d3_5 << end
0.42565 4.58154
0.173718 1.23118
0.260145 0.347362
0.565358 0.0912411
1.9852 0.0117177
end
$d3_6 << end
13.052 0.0161666
31.56 0.0161666
53.6555 0.0161666
94.2709 0.0161666
end
$d3_7 << end
9.17507 1.07474
23.141 0.678558
37.5974 0.68419
57.915 0.661954
end
$d3_8 << end
54.6716 0.125155
54.9634 0.0090866
54.3373 0.0090866
55.0696 0.00580957
end
$d3_9 << end
138.039 17.4516
161.124 8.2022
245.481 4.77779
408.538 1.89815
end
$d3_10 << end
3.41317 0.142958
3.81442 0.142958
5.44517 0.0585267
7.29044 0.0327248
end
$d4_0 << end
0.414194 0.294324
0.399091 0.117166
0.464168 0.0596952
0.631796 0.0316593
0.931029 0.00789777
end
$d4_1 << end
0.362407 0.214248
0.412902 0.134069
0.482545 0.0579277
0.662181 0.0206483
0.981314 0.0236108
end
$d4_2 << end
3.50581 0.676352
5.60553 0.19837
8.7363 0.187711
18.8859 0.0236108
end
$d4_3 << end
1.28562 9.52545
1.01094 2.68703
0.705315 0.768625
0.600059 0.171573
1.84148 0.0417236
6.99404 0.01182
23.7431 0.00127221
end
$d4_4 << end
2.40293 9.52545
1.92027 2.68703
2.31763 0.768625
4.06986 0.171573
7.22849 0.0417236
end
$d4_5 << end
1.15678 9.52545
0.990577 2.68703
0.692736 0.768625
0.58018 0.171573
1.69839 0.0417236
end
$d4_6 << end
40.9888 0.00646437
85.5866 0.00646437
171.293 0.00646437
297.741 0.00646437
end
$d4_7 << end
30.3517 16
64.7486 0.618896
105.569 0.636981
174.883 0.665414
end
$d4_8 << end
144.971 0.138234
144.526 0.0254922
end
$d4_9 << end
235.583 40.7916
271.024 17.1306
392.415 11.6081
670.229 4.71935
end
$d4_10 << end
6.42039 0.171573
7.4585 0.114541
9.40144 0.0592309
14.0166 0.0238257
end
$d5_0 << end
0.349177 0.246396
0.375957 0.176901
0.412151 0.0757754
0.565437 0.0280046
0.746146 0.0157699
end
$d5_1 << end
0.273135 0.286548
0.304421 0.217291
0.376418 0.0919876
0.509605 0.0458824
0.747488 0.0157699
end
$d5_2 << end
1.15691 0.821871
1.90969 0.339211
3.45099 0.197577
7.25419 0.0611845
end
$d5_3 << end
0.764102 6.82294
0.261768 1.17148
0.307406 0.405697
0.80296 0.084288
2.45642 0.0181551
8.91596 0.00405588
27.2813 0.00142208
end
$d5_4 << end
0.828287 6.82294
0.926763 1.17148
1.39838 0.405697
3.07716 0.084288
8.61997 0.0181551
end
$d5_5 << end
0.6146 6.82294
0.188519 1.17148
0.307566 0.405697
0.76992 0.084288
2.35693 0.0181551
end
$d5_6 << end
13.6191 0.016656
28.2587 0.016656
57.303 0.016656
100.272 0.016656
end
$d5_7 << end
9.78377 8.38636
24.003 0.597742
39.9981 0.623981
58.3789 0.631364
end
$d5_8 << end
60.3529 0.153149
end
$d5_9 << end
115.395 13.7542
133.006 6.43314
194.786 3.23415
325.95 1.72338
end
$d5_10 << end
4.43703 0.274238
6.06506 0.103817
6.65033 0.084288
10.5572 0.0279317
end
$d6_0 << end
1.46089 0.437158
0.873033 0.0674436
1.03708 0.0674436
1.47349 0.0317614
1.4184 0.00888459
end
$d6_1 << end
1.65644 0.48735
2.03532 0.2075
2.18387 0.096966
1.77252 0.0436791
2.52852 0.0182582
end
$d6_2 << end
5.42719 0.478035
7.66957 0.214926
9.91962 0.110032
22.3587 0.0338142
end
$d6_3 << end
3.71294 2.34843
1.33169 0.851351
1.75967 0.214926
2.70229 0.0289812
8.54324 0.00639368
27.1118 0.000112701
94.5912 0.000112701
end
$d6_4 << end
5.32975 2.34843
9.52044 0.851351
8.16272 0.214926
15.1721 0.0289812
42.6046 0.00639368
end
$d6_5 << end
2.92903 2.34843
1.27401 0.851351
0.931931 0.214926
3.32463 0.0289812
10.6186 0.00639368
end
$d6_6 << end
106.401 0.0144088
195.747 0.0144088
417.71 0.0144088
650.976 0.0144088
end
$d6_7 << end
44.264 0.61348
122.651 0.585633
252.291 0.600581
360.7 0.646489
end
$d6_8 << end
287.207 0.0114275
end
$d6_9 << end
181.772 13.1394
184.621 6.30183
228.795 3.97103
326.289 2.04498
end
$d6_10 << end
11.4205 0.214926
11.0582 0.214926
14.6357 0.0531925
20.1292 0.0129983
end
$d7_0 << end
1.0412 0.102831
0.977898 0.0872668
0.993642 0.0872668
1.07722 0.0245429
1.33864 0.00872391
end
$d7_1 << end
1.25503 0.124749
1.36433 0.124749
1.52638 0.0486149
2.08173 0.0181237
3.11844 0.0146743
end
$d7_2 << end
8.16573 0.231083
9.23686 0.142443
13.2076 0.0688788
27.0257 0.0381779
end
$d7_3 << end
5.13163 3.1378
5.71077 0.85607
2.26825 0.175312
2.5084 0.0381779
6.39441 0.00659181
21.5744 0.00213027
76.8565 0.000332701
end
$d7_4 << end
10.8576 3.1378
11.5194 0.85607
13.6632 0.175312
18.9412 0.0381779
39.9092 0.00659181
end
$d7_5 << end
4.69434 3.1378
5.08826 0.85607
1.99278 0.175312
2.09701 0.0381779
5.7435 0.00659181
end
$d7_6 << end
172.067 0.00731614
360.805 0.00713256
808.485 0.00713256
1324.9 0.00713256
end
$d7_7 << end
96.9132 0.602107
272.84 0.616223
545.918 0.616223
880.378 0.635802
end
$d7_8 << end
206.14 28.3646
231.141 11.8414
278.773 6.16002
389.95 2.83254
end
$d7_9 << end
17.9003 0.0868215
21.6883 0.0381779
24.3505 0.0231854
33.6682 0.00926024
end
$d8_0 << end
0.520912 0.409218
0.60745 0.130562
0.753456 0.134721
0.89817 0.0377867
1.41181 0.0201101
end
$d8_1 << end
0.787597 0.474817
0.917579 0.191897
1.05455 0.1043
1.49262 0.0457064
2.63339 0.0195869
end
$d8_2 << end
4.27447 0.453333
7.61307 0.377984
13.3821 0.103518
32.0246 0.0608294
end
$d8_3 << end
2.17969 2.44984
0.44579 0.639867
1.02864 0.194376
3.0768 0.037334
9.64831 0.00994697
31.6308 0.00248462
88.0849 0.00129747
end
$d8_4 << end
2.41303 2.44984
3.10759 0.639867
4.67617 0.194376
10.5515 0.037334
33.744 0.00994697
end
$d8_5 << end
1.27765 2.44984
0.432991 0.639867
0.910169 0.194376
2.45691 0.037334
9.90084 0.00994697
end
$d8_6 << end
57.6206 0.0340913
114.973 0.0222283
229.369 0.0222283
384.883 0.0222283
end
$d8_7 << end
35.0398 0.65172
90.0372 0.624137
146.887 0.649739
245.039 0.643614
end
$d8_8 << end
190.526 0.169863
192.538 0.0369673
192.704 0.0106697
193.591 0.00465298
end
$d8_9 << end
204.705 17.5043
196.677 9.07526
229.472 4.65613
326.894 2.08489
end
$d8_10 << end
8.76567 0.194376
11.3931 0.0795511
11.7931 0.0795511
16.5246 0.0293478
end
$d9_0 << end
3.44301 0.496405
3.15722 0.128249
3.94214 0.127776
4.15521 0.0499481
6.22273 0.0275697
end
$d9_1 << end
3.77507 0.685299
3.71516 0.213831
4.91781 0.118751
6.38122 0.0635638
9.14639 0.0233497
end
$d9_2 << end
9.45069 0.495956
15.9835 0.286077
31.7401 0.150413
77.3902 0.0784139
end
$d9_3 << end
2.21445 3.12366
1.89855 0.836907
5.02196 0.247131
15.1259 0.0665993
49.0836 0.00850119
end
$d9_4 << end
5.50141 3.12366
9.56306 0.836907
23.8085 0.247131
81.6209 0.0665993
end
$d9_5 << end
1.89921 3.12366
1.45062 0.836907
4.75205 0.247131
15.0273 0.0665993
end
$d9_6 << end
71.3183 0.0202976
144.51 0.00876149
281.28 0.00876149
492.051 0.00876149
end
$d9_7 << end
38.2355 1.81597
98.1135 0.601578
170.596 0.675885
276.33 0.636386
end
$d9_8 << end
241.048 0.149426
240.704 0.0360529
244.119 0.0157577
246.706 0.00862334
end
$d9_9 << end
145.136 11.8326
167.734 7.44346
215.51 3.33876
322.427 1.52939
end
$d9_10 << end
23.4771 0.256166
23.4959 0.256166
36.8901 0.0848854
52.2615 0.0665993
end
$d10_0 << end
3.68892 0.263987
3.75378 0.242959
3.96639 0.143692
5.57648 0.0528481
6.76842 0.0226918
end
$d10_1 << end
4.11818 0.543688
5.08918 0.276982
5.81985 0.120338
8.23437 0.0516379
12.3268 0.024345
end
$d10_2 << end
12.7131 0.473492
23.2782 0.192967
40.5312 0.148114
100.793 0.0438457
end
$d10_3 << end
3.80728 5.28405
2.15054 1.3061
4.59698 0.383861
13.8814 0.0909569
47.0357 0.0174457
end
$d10_4 << end
9.36467 5.28405
13.1004 1.3061
26.2422 0.383861
76.0677 0.0909569
end
$d10_5 << end
3.27479 5.28405
1.71215 1.3061
4.13597 0.383861
13.5008 0.0909569
end
$d10_6 << end
153.218 0.00911068
310.246 0.00321158
657.351 0.00506085
1099.04 0.00506085
end
$d10_7 << end
82.6328 0.628235
227.305 0.610583
462.152 0.628481
824.44 0.683871
end
$d10_8 << end
451.481 0.15301
449.767 0.0380473
452.892 0.0123264
461.012 0.00791634
end
$d10_9 << end
243.321 26.4744
284.858 13.0583
370.416 6.64838
548.213 2.89832
end
$d10_10 << end
33.1418 0.383861
46.6979 0.234303
61.7465 0.0909569
100.039 0.0466781
end
$d11_0 << end
3.52584 0.345056
3.13364 0.159376
4.04782 0.106179
4.61192 0.0523258
5.81411 0.0267119
end
$d11_1 << end
3.47001 0.491808
3.61787 0.310184
5.39433 0.126328
6.85986 0.054526
10.9227 0.0307251
end
$d11_2 << end
11.371 0.614287
18.56 0.355659
41.4531 0.109309
92.8976 0.0404731
end
$d11_3 << end
2.73754 3.65155
3.19718 1.04791
6.21787 0.288699
15.9795 0.0587762
49.3001 0.0138196
end
$d11_4 << end
5.91609 3.65155
11.2594 1.04791
24.7052 0.288699
85.0363 0.0587762
end
$d11_5 << end
1.99862 3.65155
2.1609 1.04791
4.59314 0.288699
16.7817 0.0587762
end
$d11_6 << end
82.9852 0.012271
154.851 0.012271
346.669 0.012271
544.283 0.012271
end
$d11_7 << end
43.1353 0.620711
112.528 0.624
183.514 0.675235
303.952 0.664088
end
$d11_8 << end
240.513 0.155599
240.335 0.0409791
254.392 0.0164609
253.093 0.00705221
end
$d11_9 << end
123.403 18.2891
145.485 8.98901
185.247 4.50026
318.728 2.254
end
$d11_10 << end
27.9834 0.288699
29.8609 0.288699
34.8205 0.0929819
66.9851 0.0404731
end
$d12_0 << end
14.4716 0.242011
18.7786 0.152234
18.9304 0.0694318
32.1818 0.0298556
29.2479 0.0143453
end
$d12_1 << end
14.716 0.381005
15.8047 0.242011
17.5953 0.0834074
22.843 0.0437911
32.8043 0.0143453
end
$d12_2 << end
33.1832 0.578935
57.8646 0.337727
108.22 0.138599
248.947 0.035524
end
$d12_3 << end
5.89242 0.969862
9.26559 0.211598
30.3946 0.0394482
88.7773 0.0113739
end
$d12_4 << end
17.2639 0.969862
29.4721 0.211598
87.1264 0.0394482
end
$d12_5 << end
2.4055 0.969862
6.29939 0.211598
21.8601 0.0394482
end
$d12_6 << end
164.386 0.0357932
370.09 0.0174715
609.191 0.0174715
1026.1 0.0174715
end
$d12_7 << end
98.0775 16
254.19 0.54363
399.336 0.598398
868.244 0.63027
end
$d12_8 << end
597.005 0.132094
605.418 0.0285002
663.268 0.00955743
660.686 0.00553949
end
$d12_9 << end
299.492 63.2139
311.496 45.5494
371.652 17.2114
544.58 7.91942
end
$d12_10 << end
80.9408 0.0394482
74.4564 0.0394482
132.169 0.012691
215.941 0.00268785
end
$d13_0 << end
12.7461 0.268983
12.2288 0.174134
12.9597 0.102036
24.1001 0.0242444
36.5483 0.0138848
end
$d13_1 << end
10.6087 0.345527
11.2735 0.298992
18.0002 0.115417
21.4915 0.0446806
26.2753 0.0171081
end
$d13_2 << end
29.1309 0.424949
51.7306 0.230491
89.0812 0.103092
217.164 0.0255139
end
$d13_3 << end
3.90443 0.775775
6.85115 0.158495
19.8587 0.024857
70.4911 0.00618285
end
$d13_4 << end
14.7432 0.775775
26.3108 0.158495
84.4019 0.024857
end
$d13_5 << end
2.93528 0.775775
5.34656 0.158495
18.1183 0.024857
end
$d13_6 << end
178.805 0.0138848
335.245 0.000589907
715.315 0.000589907
1250.72 0.000589907
end
$d13_7 << end
101.081 16
240.887 0.627358
440.135 0.687581
625.467 0.654962
end
$d13_8 << end
586.447 0.154575
592.922 0.0292246
605.938 0.0152017
619.825 0.0044893
end
$d13_9 << end
410.062 22.8634
391.787 10.5501
411.928 6.13612
585.337 2.50865
end
$d13_10 << end
55.1235 0.024857
87.9756 0.00914146
137.589 0.00618285
326.197 0.000589907
end
$d14_0 << end
17.4055 0.147679
19.4168 0.0723985
28.8683 0.0338369
33.8477 0.0177094
31.5558 0.00999439
end
$d14_1 << end
21.919 0.470219
15.0787 0.24068
21.1966 0.050068
22.1521 0.0177094
25.4817 0.00999439
end
$d14_2 << end
17.5117 0.405303
25.3441 0.314287
41.7912 0.0958438
94.3514 0.0463156
end
$d14_3 << end
4.41615 0.0919171
9.84908 0.0141345
29.4392 0.00105269
94.0907 0.000467914
end
$d14_4 << end
16.73 0.0919171
30.7513 0.0141345
105.691 0.00105269
end
$d14_5 << end
2.24708 0.0919171
8.10298 0.0141345
28.9924 0.00105269
end
$d14_6 << end
70.0486 0.00999439
171.939 0.00999439
329.92 0.00999439
511.204 0.00999439
end
$d14_7 << end
94.5437 0.582201
197.687 0.549583
334.948 0.58987
431.569 0.58987
end
$d14_8 << end
149.382 15.339
170.65 7.50831
225.805 3.68713
373.846 1.70252
end
$d14_9 << end
39.7671 0.0141345
36.8587 0.0141345
33.4172 0.0141345
94.6593 0.00105269
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
set xrange [0.622634:2064.57]
set yrange [0.00317759:32.7818]
set label 'afd' at graph 0.3013,0.0200 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5630,0.0255 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7463,0.0906 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.6172,0.1559 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2897,0.1497 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2210 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5980,0.2955 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4999,0.3773 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2559,0.4426 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7870,0.5781 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8314,0.7222 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d0_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'teapot, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.10115:4246.77]
set yrange [0.0026193:63.6289]
set label 'afd' at graph 0.2649,0.0200 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.4525,0.0280 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7204,0.0931 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5614,0.1584 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2236 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2566,0.1583 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5396,0.2887 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4548,0.3943 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.1694,0.4595 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7867,0.5480 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7467,0.7370 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d1_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d1_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d1_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d1_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d1_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d1_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d1_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d1_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d1_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d1_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d1_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'teapot, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.16354:3525.01]
set yrange [0.00260346:53.1319]
set label 'afd' at graph 0.2683,0.0200 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5067,0.0578 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.0579 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7350,0.1231 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5630,0.1882 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2563,0.1946 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5775,0.3121 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4693,0.3772 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2458,0.4425 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7595,0.5570 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7435,0.7161 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d2_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d2_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d2_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d2_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d2_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d2_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d2_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d2_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d2_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d2_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d2_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.117835:2085.57]
set yrange [0.000487139:35.1113]
set label 'tessellation' at graph 0.5349,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.6285,0.2014 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'fd' at graph 0.1583,0.1394 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1702,0.2045 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.4103,0.2696 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2887,0.3349 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.6834,0.3348 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'mesa' at graph 0.4217,0.4000 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4395,0.4651 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.6336,0.6450 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7392 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d3_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d3_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d3_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d3_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d3_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d3_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d3_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d3_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d3_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d3_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d3_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.248797:3253.11]
set yrange [0.000757283:84.3318]
set label 'tessellation' at graph 0.4809,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'micropolygons' at graph 0.7477,0.1688 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.1392,0.1681 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1448,0.2332 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4568,0.2339 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.4253,0.2991 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.6715,0.3707 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.3555,0.3644 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2026,0.4295 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.6916,0.5833 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7519 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d4_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d4_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d4_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d4_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d4_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d4_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d4_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d4_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d4_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d4_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d4_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.129857:1559.87]
set yrange [0.00089877:26.147]
set label 'tessellation' at graph 0.5693,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.1861,0.1547 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1863,0.2199 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7078,0.2199 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'zsort' at graph 0.4466,0.2850 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3086,0.3501 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.4682,0.4154 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4283,0.4805 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'scanline' at graph 0.6538,0.5457 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'isocurves' at graph 0.6503,0.6377 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7354 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d5_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d5_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d5_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d5_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d5_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d5_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d5_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d5_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d5_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d5_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d5_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.627197:2610.94]
set yrange [6.2892e-05:29.7331]
set label 'tessellation' at graph 0.6019,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.5062,0.2713 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3395,0.3364 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'afd' at graph 0.0979,0.4015 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'scanline' at graph 0.7351,0.3744 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.4162,0.4016 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4397 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.1673,0.4668 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4288,0.5319 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7625,0.7070 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7505,0.7951 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d6_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d6_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d6_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d6_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d6_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d6_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d6_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d6_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d6_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d6_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d6_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.681866:6023.93]
set yrange [0.00018859:62.7953]
set label 'tessellation' at graph 0.5200,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.4479,0.1908 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2345,0.2559 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2857 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.0742,0.3211 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'mesa' at graph 0.4292,0.3211 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.1673,0.3864 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4050,0.4515 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7883,0.6388 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6987,0.7563 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d7_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d7_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d7_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d7_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d7_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d7_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d7_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d7_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d7_8 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d7_9 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.308345:1601.72]
set yrange [0.000806483:34.0603]
set label 'tessellation' at graph 0.6610,0.0252 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7530,0.0903 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.5488,0.1555 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.4055,0.2206 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'fd' at graph 0.2507,0.2859 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1778,0.3510 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3114 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'mesa' at graph 0.4654,0.4161 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5427,0.4812 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7806,0.6274 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8142,0.7377 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d8_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d8_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d8_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d8_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d8_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d8_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d8_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d8_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d8_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d8_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d8_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.084:1672.65]
set yrange [0.0059197:19.6396]
set label 'tessellation' at graph 0.5194,0.0200 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7393,0.0464 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1117 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2905,0.1428 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.2380,0.2079 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.5886,0.2080 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3581,0.2730 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5279,0.3383 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5814,0.4034 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7547,0.5770 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7758,0.6851 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d9_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d9_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d9_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d9_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d9_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d9_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d9_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d9_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d9_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d9_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d9_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.23928:4271.52]
set yrange [0.00204604:49.7684]
set label 'micropolygons' at graph 0.8333,0.0200 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7267,0.0584 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4464,0.1235 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.2084,0.1886 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2820,0.2539 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5400,0.3190 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5391,0.3840 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5055,0.4491 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2932,0.5142 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7980,0.5755 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7479,0.7185 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d10_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d10_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d10_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d10_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d10_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d10_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d10_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d10_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d10_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d10_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d10_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.50999:1766.83]
set yrange [0.00476027:31.7076]
set label 'scanline' at graph 0.7249,0.0435 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1087 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.4934,0.1211 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.1908,0.1247 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2801,0.1898 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5831,0.1898 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5368,0.2551 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5706,0.3202 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3409,0.3853 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7509,0.5609 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7576,0.6997 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d11_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d11_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d11_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d11_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d11_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d11_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d11_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d11_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d11_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d11_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d11_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.77708:3660.04]
set yrange [0.00162493:127.882]
set label 'mesa' at graph 0.6291,0.0200 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7756,0.0311 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.5126,0.0962 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3671,0.1613 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3821,0.2266 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2107 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.6477,0.2917 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5101,0.3568 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3289,0.4220 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.8114,0.5287 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7503,0.7532 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d12_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d12_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d12_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d12_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d12_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d12_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d12_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d12_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d12_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d12_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d12_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [2.16857:4460.23]
set yrange [0.000347829:47.8989]
set label 'micropolygons' at graph 0.8333,0.0200 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'mesa' at graph 0.6572,0.0645 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7413,0.1296 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4563,0.1947 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3702,0.2600 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3270,0.3251 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'zsort' at graph 0.4800,0.3902 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2783,0.4553 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.6038,0.4553 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7425,0.6373 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7338,0.7508 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d13_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d13_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d13_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d13_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d13_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d13_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d13_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d13_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d13_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d13_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d13_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.71305:1597.94]
set yrange [0.000278218:31.7608]
set label 'tessellation' at graph 0.5858,0.0200 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.6028,0.0642 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.4137,0.1295 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5867,0.1947 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'afd' at graph 0.4261,0.2749 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3948,0.3402 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3075 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5862,0.4392 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.8086,0.6577 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7876,0.7487 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d14_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d14_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d14_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d14_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d14_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d14_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d14_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d14_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d14_8 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d14_9 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
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
set xrange [0.622634:2064.57]
set yrange [0.00317759:32.7818]
set label 'afd' at graph 0.3013,0.0200 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5630,0.0370 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7463,0.0906 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.6172,0.1444 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2897,0.1497 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1981 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5980,0.2955 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4999,0.3831 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2559,0.4369 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7870,0.5781 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8314,0.7222 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d0_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'teapot, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.10115:4246.77]
set yrange [0.0026193:63.6289]
set label 'afd' at graph 0.2649,0.0200 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.4525,0.0439 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7204,0.0977 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5614,0.1514 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2050 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2566,0.1583 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5396,0.2665 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4548,0.4000 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.1694,0.4538 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7867,0.5480 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7467,0.7370 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d1_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d1_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d1_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d1_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d1_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d1_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d1_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d1_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d1_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d1_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d1_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'teapot, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.16354:3525.01]
set yrange [0.00260346:53.1319]
set label 'afd' at graph 0.2683,0.0200 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5067,0.0623 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.0625 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7350,0.1163 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5630,0.1700 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2563,0.1946 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5775,0.3138 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4693,0.3821 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2458,0.4359 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7595,0.5570 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7435,0.7161 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d2_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d2_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d2_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d2_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d2_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d2_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d2_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d2_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d2_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d2_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d2_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.117835:2085.57]
set yrange [0.000487139:35.1113]
set label 'tessellation' at graph 0.5349,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.6285,0.2175 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'fd' at graph 0.1583,0.1666 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1702,0.2202 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.4103,0.2739 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2887,0.3277 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.6834,0.3276 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'mesa' at graph 0.4217,0.3813 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4395,0.4350 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.6336,0.6450 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7392 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d3_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d3_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d3_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d3_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d3_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d3_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d3_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d3_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d3_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d3_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d3_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.248797:3253.11]
set yrange [0.000757283:84.3318]
set label 'tessellation' at graph 0.4809,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'micropolygons' at graph 0.7477,0.1845 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.1392,0.1892 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1448,0.2428 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4568,0.2428 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.4253,0.2966 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.6715,0.3575 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.3555,0.3503 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2026,0.4039 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.6916,0.5833 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7519 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d4_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d4_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d4_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d4_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d4_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d4_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d4_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d4_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d4_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d4_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d4_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'band, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.129857:1559.87]
set yrange [0.00089877:26.147]
set label 'tessellation' at graph 0.5693,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.1861,0.1863 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.1863,0.2400 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.7078,0.2400 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'zsort' at graph 0.4466,0.2936 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3086,0.3473 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.4682,0.4011 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.4283,0.4547 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'scanline' at graph 0.6538,0.5084 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'isocurves' at graph 0.6503,0.6377 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.7354 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d5_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d5_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d5_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d5_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d5_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d5_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d5_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d5_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d5_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d5_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d5_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.627197:2610.94]
set yrange [6.2892e-05:29.7331]
set label 'tessellation' at graph 0.6019,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.5062,0.2943 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3395,0.3479 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'afd' at graph 0.0979,0.4015 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'scanline' at graph 0.7351,0.3801 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.4162,0.4016 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'micropolygons' at graph 0.8333,0.4339 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.1673,0.4553 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4288,0.5089 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7625,0.7070 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7505,0.7951 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d6_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d6_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d6_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d6_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d6_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d6_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d6_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d6_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d6_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d6_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d6_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.681866:6023.93]
set yrange [0.00018859:62.7953]
set label 'tessellation' at graph 0.5200,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.4479,0.2138 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2345,0.2674 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2857 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'afd' at graph 0.0742,0.3212 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'mesa' at graph 0.4292,0.3211 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.1673,0.3748 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.4050,0.4284 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7883,0.6388 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.6987,0.7563 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d7_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d7_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d7_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d7_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d7_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d7_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d7_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d7_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d7_8 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d7_9 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'lampshade, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [0.308345:1601.72]
set yrange [0.000806483:34.0603]
set label 'tessellation' at graph 0.6610,0.0446 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7530,0.1221 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'zsort' at graph 0.5488,0.1757 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.4055,0.2293 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'fd' at graph 0.2507,0.2830 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.1778,0.3366 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3114 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'mesa' at graph 0.4654,0.3904 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5427,0.4440 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7806,0.6274 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8142,0.7377 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d8_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d8_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d8_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d8_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d8_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d8_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d8_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d8_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d8_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d8_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d8_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.084:1672.65]
set yrange [0.0059197:19.6396]
set label 'tessellation' at graph 0.5194,0.0200 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7393,0.0464 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1002 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'fd' at graph 0.2905,0.1526 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.2380,0.2064 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'zsort' at graph 0.5886,0.2231 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3581,0.2767 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5279,0.3305 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.5814,0.3841 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7547,0.5770 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7758,0.6851 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d9_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d9_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d9_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d9_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d9_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d9_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d9_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d9_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d9_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d9_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d9_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.23928:4271.52]
set yrange [0.00204604:49.7684]
set label 'micropolygons' at graph 0.8333,0.0392 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.7267,0.0928 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4464,0.1465 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.2084,0.2001 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2820,0.2539 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5400,0.3075 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5391,0.3611 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5055,0.4147 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2932,0.4683 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7980,0.5755 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7479,0.7185 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d10_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d10_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d10_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d10_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d10_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d10_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d10_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d10_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d10_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d10_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d10_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'knot, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.50999:1766.83]
set yrange [0.00476027:31.7076]
set label 'scanline' at graph 0.7249,0.0446 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1076 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.4934,0.1211 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.1908,0.1458 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.2801,0.1994 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'subdivision' at graph 0.5831,0.1994 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'mesa' at graph 0.5368,0.2532 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'zsort' at graph 0.5706,0.3068 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3409,0.3604 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7509,0.5609 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7576,0.6997 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d11_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d11_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d11_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d11_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d11_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d11_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d11_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d11_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d11_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d11_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d11_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, full' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.77708:3660.04]
set yrange [0.00162493:127.882]
set label 'mesa' at graph 0.6291,0.0200 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7756,0.0598 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.5126,0.1134 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3671,0.1671 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3821,0.2209 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2107 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.6477,0.2745 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5101,0.3282 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3289,0.3818 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.8114,0.5287 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7503,0.7532 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d12_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d12_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d12_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d12_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d12_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d12_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d12_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d12_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d12_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d12_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d12_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, closeup' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [2.16857:4460.23]
set yrange [0.000347829:47.8989]
set label 'micropolygons' at graph 0.8333,0.0200 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'mesa' at graph 0.6572,0.0715 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'scanline' at graph 0.7413,0.1589 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'tessellation' at graph 0.4563,0.2125 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'afd' at graph 0.3702,0.2661 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3270,0.3197 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'zsort' at graph 0.4800,0.3734 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2783,0.4272 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.6038,0.4271 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7425,0.6373 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7338,0.7508 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d13_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d13_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d13_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d13_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d13_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d13_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d13_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d13_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d13_8 using 1:2 with linespoints lw 1.1199999999999999 pt 8 ps 0.5 lc rgb '#7a4a1e' notitle, \
     $d13_9 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d13_10 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset label
unset key
set title 'hills, top' noenhanced
set xlabel 'milliseconds a frame'
set ylabel 'pixels'
set xrange [1.71305:1597.94]
set yrange [0.000278218:31.7608]
set label 'tessellation' at graph 0.5858,0.0200 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'zsort' at graph 0.6028,0.0700 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.4137,0.1238 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'mesa' at graph 0.5867,0.1774 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'afd' at graph 0.4261,0.2806 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.3948,0.3344 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.3075 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5862,0.4392 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.8086,0.6577 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.7876,0.7487 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d14_0 using 1:2 with linespoints lw 2.0999999999999996 pt 7 ps 0.5 lc rgb '#000000' notitle, \
     $d14_1 using 1:2 with linespoints lw 1.1199999999999999 pt 5 ps 0.5 lc rgb '#0072b2' notitle, \
     $d14_2 using 1:2 with linespoints lw 1.1199999999999999 pt 9 ps 0.5 lc rgb '#009e73' notitle, \
     $d14_3 using 1:2 with linespoints lw 1.1199999999999999 pt 13 ps 0.5 lc rgb '#e69f00' notitle, \
     $d14_4 using 1:2 with linespoints lw 1.1199999999999999 pt 11 ps 0.5 lc rgb '#d55e00' notitle, \
     $d14_5 using 1:2 with linespoints lw 0.84 pt 12 ps 0.5 lc rgb '#8a8500' notitle, \
     $d14_6 using 1:2 with linespoints lw 1.1199999999999999 pt 4 ps 0.5 lc rgb '#e377c2' notitle, \
     $d14_7 using 1:2 with linespoints lw 1.1199999999999999 pt 6 ps 0.5 lc rgb '#56b4e9' notitle, \
     $d14_8 using 1:2 with linespoints lw 1.1199999999999999 pt 10 ps 0.5 lc rgb '#8a8a8a' notitle, \
     $d14_9 using 1:2 with linespoints lw 1.1199999999999999 pt 15 ps 0.5 lc rgb '#6a3d9a' notitle
unset multiplot
set output
