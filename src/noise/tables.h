#pragma once
// The tables of glman's noise: for each of the four octaves a permutation and one gradient per lattice class.
// They were determined from glman's output (the texels of noise2d.064.tex and noise3d.064.tex) by a
// least-squares fit; no program code was used. Gradients are rounded to 1/10000, which is finer than the
// resolution of the fitted bytes.

#include <array>
#include <cstdint>
#include <span>

namespace glibra::noise::tables {

/// One octave of the 3D function: the gradient at lattice point (i, j, k) is gradients[(i + p[(j + q[k]) %
/// cells]) % cells].
struct Octave3 {
    int cells;
    std::span<const std::uint8_t> p, q;
    std::span<const std::array<double, 3>> gradients;
};

/// One octave of the 2D function: the gradient at lattice point (i, j) is gradients[(i + p[j]) % cells].
struct Octave2 {
    int cells;
    std::span<const std::uint8_t> p;
    std::span<const std::array<double, 2>> gradients;
};

// 4 cells
inline constexpr std::array<std::uint8_t, 4> kOuter4{0, 3, 1, 2};
inline constexpr std::array<std::uint8_t, 4> kInner4{0, 2, 1, 3};
inline constexpr std::array<std::array<double, 3>, 4> kGradients3Of4{{{-0.2315, 0.3882, 0.2823},
                                                                      {0.4132, 0.4733, 0.2748},
                                                                      {0.0507, -0.2061, -0.293},
                                                                      {-0.0206, -0.034, 0.1926}}};
inline constexpr std::array<std::array<double, 2>, 4> kGradients2Of4{
    {{0.019, -0.4957}, {-0.0398, 0.4323}, {0.4413, 0.2387}, {-0.3075, 0.0237}}};

// 8 cells
inline constexpr std::array<std::uint8_t, 8> kOuter8{0, 6, 7, 5, 2, 4, 1, 3};
inline constexpr std::array<std::uint8_t, 8> kInner8{0, 5, 7, 4, 6, 3, 1, 2};
inline constexpr std::array<std::array<double, 3>, 8> kGradients3Of8{{{0.2033, 0.1233, -0.2038},
                                                                      {-0.1467, 0.0096, -0.2479},
                                                                      {-0.2348, 0.0774, 0.1196},
                                                                      {0.0963, -0.02, 0.2163},
                                                                      {0.2275, 0.0566, 0.0696},
                                                                      {0.1372, -0.1537, 0.0119},
                                                                      {-0.0257, -0.0513, 0.142},
                                                                      {-0.0952, 0.038, 0.0864}}};
inline constexpr std::array<std::array<double, 2>, 8> kGradients2Of8{{{0.1413, -0.1158},
                                                                      {0.1687, 0.1246},
                                                                      {0.1412, 0.1305},
                                                                      {0.0959, 0.1579},
                                                                      {0.0977, -0.0107},
                                                                      {0.156, 0.0293},
                                                                      {0.191, 0.2063},
                                                                      {0.1583, 0.0252}}};

// 16 cells
inline constexpr std::array<std::uint8_t, 16> kOuter16{0, 15, 9, 10, 8, 13, 11, 5, 12, 3, 2, 1, 14, 7, 4, 6};
inline constexpr std::array<std::uint8_t, 16> kInner16{0, 14, 8, 15, 6, 5, 4, 1, 10, 7, 9, 3, 2, 12, 13, 11};
inline constexpr std::array<std::array<double, 3>, 16> kGradients3Of16{{{-0.0896, 0.0706, 0.0827},
                                                                        {0.0815, 0.071, -0.0473},
                                                                        {0.0802, -0.1249, -0.0606},
                                                                        {0.1159, 0.0579, -0.0854},
                                                                        {0.0794, -0.0283, -0.1172},
                                                                        {-0.0733, 0.0403, -0.0093},
                                                                        {0.0129, -0.0515, -0.0731},
                                                                        {-0.0048, -0.0083, 0.0483},
                                                                        {-0.1, -0.1092, 0.006},
                                                                        {-0.0444, 0.0381, 0.0878},
                                                                        {0.0647, -0.0369, -0.013},
                                                                        {0.0141, 0.0945, 0.1135},
                                                                        {0.0625, -0.0028, 0.1017},
                                                                        {0.061, 0.0742, 0.1241},
                                                                        {0.0923, 0.0396, -0.0699},
                                                                        {-0.0408, -0.0603, -0.1162}}};
inline constexpr std::array<std::array<double, 2>, 16> kGradients2Of16{{{-0.1162, 0.0096},
                                                                        {-0.1149, 0.0094},
                                                                        {-0.0221, -0.0642},
                                                                        {-0.0029, -0.0988},
                                                                        {0.02, 0.0439},
                                                                        {0.0961, 0.0224},
                                                                        {0.0961, 0.0437},
                                                                        {0.0394, 0.06},
                                                                        {-0.0775, -0.0757},
                                                                        {0.0038, -0.124},
                                                                        {-0.0105, 0.1081},
                                                                        {0.022, 0.0463},
                                                                        {-0.1097, -0.0377},
                                                                        {-0.0254, 0.0705},
                                                                        {0.0298, 0.0349},
                                                                        {0.0618, -0.1022}}};

// 32 cells
inline constexpr std::array<std::uint8_t, 32> kOuter32{0,  19, 2,  18, 3,  11, 25, 7,  1,  29, 30,
                                                       22, 4,  8,  15, 26, 6,  10, 31, 17, 21, 20,
                                                       12, 5,  27, 13, 9,  14, 28, 16, 24, 23};
inline constexpr std::array<std::uint8_t, 32> kInner32{0,  14, 2,  10, 9,  18, 5,  20, 4,  21, 29,
                                                       11, 25, 19, 15, 16, 8,  22, 26, 1,  12, 24,
                                                       28, 17, 3,  7,  6,  30, 23, 13, 31, 27};
inline constexpr std::array<std::array<double, 3>, 32> kGradients3Of32{
    {{0.0057, -0.0471, -0.0325}, {-0.0223, 0.0504, 0.0092},   {0.0075, 0.0176, 0.0201},
     {0.0629, -0.0536, 0.0004},  {-0.0198, 0.0145, 0.018},    {-0.0488, -0.0192, -0.0386},
     {0.0219, -0.0531, -0.0172}, {-0.0509, -0.0063, -0.0347}, {-0.0525, 0.0235, 0.0258},
     {0.0478, 0.0027, -0.0521},  {0.0206, -0.0026, -0.03},    {0.0002, -0.0348, -0.0402},
     {-0.0001, -0.0286, 0.0028}, {-0.0011, 0.0018, -0.0113},  {0.0026, -0.0221, 0.041},
     {-0.0292, -0.0529, 0.0007}, {-0.0058, 0.0486, 0.054},    {0.0487, -0.0503, -0.0225},
     {-0.0283, -0.0018, 0.0423}, {-0.0008, -0.0076, 0.0334},  {0.0676, 0.0008, 0.059},
     {0.0193, 0.0571, 0.0601},   {0.0433, -0.02, -0.0594},    {-0.0537, 0.055, 0.0431},
     {-0.0086, -0.0222, 0.0432}, {-0.013, -0.0086, -0.0598},  {-0.0368, 0.0419, -0.0351},
     {0.0409, 0.0618, -0.0009},  {-0.0373, 0.0519, 0.0187},   {-0.0432, -0.0451, 0.0486},
     {0.005, 0.0138, -0.032},    {0.0578, 0.0343, -0.054}}};
inline constexpr std::array<std::array<double, 2>, 32> kGradients2Of32{
    {{-0.0079, -0.0327}, {0.0349, -0.0215},  {0.0539, -0.0265}, {0.055, 0.0394},    {-0.0164, -0.0122},
     {0.0407, 0.0319},   {-0.0164, 0.0153},  {-0.0088, 0.0325}, {0.034, -0.0277},   {-0.053, 0.009},
     {-0.0597, 0.0112},  {-0.0056, -0.0499}, {0.0429, -0.0385}, {-0.0211, -0.0601}, {-0.0041, -0.0442},
     {-0.0445, 0.0576},  {-0.0247, -0.0325}, {0.0248, 0.0396},  {0.0534, -0.0101},  {-0.0507, -0.0366},
     {-0.0411, 0.0318},  {0.033, 0.0466},    {0.0338, 0.0323},  {-0.0417, -0.0489}, {0.017, -0.0116},
     {-0.0168, 0.0397},  {0.0394, 0.0076},   {-0.029, -0.0195}, {0.0502, -0.0533},  {0.0027, 0.057},
     {-0.0275, 0.0481},  {-0.008, 0.0421}}};

inline constexpr std::array<Octave3, 4> kOctaves3{{
    {4, kOuter4, kInner4, kGradients3Of4},
    {8, kOuter8, kInner8, kGradients3Of8},
    {16, kOuter16, kInner16, kGradients3Of16},
    {32, kOuter32, kInner32, kGradients3Of32},
}};
// The 2D function permutes with the inner table of the 3D one.
inline constexpr std::array<Octave2, 4> kOctaves2{{
    {4, kInner4, kGradients2Of4},
    {8, kInner8, kGradients2Of8},
    {16, kInner16, kGradients2Of16},
    {32, kInner32, kGradients2Of32},
}};

}  // namespace glibra::noise::tables
