#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <burin/base/double_double.hpp>
#include <burin/base/math.hpp>

namespace burin::math {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// 2^(i/32): the nearest double and the double nearest to the rest.
constexpr std::array<DoubleDouble, 32> powers_of_two{{
    {0x1p0, 0.0},
    {0x1.059b0d3158574p0, 0x1.d73e2a475b465p-55},
    {0x1.0b5586cf9890fp0, 0x1.8a62e4adc610bp-54},
    {0x1.11301d0125b51p0, -0x1.6c51039449b3ap-54},
    {0x1.172b83c7d517bp0, -0x1.19041b9d78a76p-55},
    {0x1.1d4873168b9aap0, 0x1.e016e00a2643cp-54},
    {0x1.2387a6e756238p0, 0x1.9b07eb6c70573p-54},
    {0x1.29e9df51fdee1p0, 0x1.612e8afad1255p-55},
    {0x1.306fe0a31b715p0, 0x1.6f46ad23182e4p-55},
    {0x1.371a7373aa9cbp0, -0x1.63aeabf42eae2p-54},
    {0x1.3dea64c123422p0, 0x1.ada0911f09ebcp-55},
    {0x1.44e086061892dp0, 0x1.89b7a04ef80dp-59},
    {0x1.4bfdad5362a27p0, 0x1.d4397afec42e2p-56},
    {0x1.5342b569d4f82p0, -0x1.07abe1db13cadp-55},
    {0x1.5ab07dd485429p0, 0x1.6324c054647adp-54},
    {0x1.6247eb03a5585p0, -0x1.383c17e40b497p-54},
    {0x1.6a09e667f3bcdp0, -0x1.bdd3413b26456p-54},
    {0x1.71f75e8ec5f74p0, -0x1.16e4786887a99p-55},
    {0x1.7a11473eb0187p0, -0x1.41577ee04992fp-55},
    {0x1.82589994cce13p0, -0x1.d4c1dd41532d8p-54},
    {0x1.8ace5422aa0dbp0, 0x1.6e9f156864b27p-54},
    {0x1.93737b0cdc5e5p0, -0x1.75fc781b57ebcp-57},
    {0x1.9c49182a3f09p0, 0x1.c7c46b071f2bep-56},
    {0x1.a5503b23e255dp0, -0x1.d2f6edb8d41e1p-54},
    {0x1.ae89f995ad3adp0, 0x1.7a1cd345dcc81p-54},
    {0x1.b7f76f2fb5e47p0, -0x1.5584f7e54ac3bp-56},
    {0x1.c199bdd85529cp0, 0x1.11065895048ddp-55},
    {0x1.cb720dcef9069p0, 0x1.503cbd1e949dbp-56},
    {0x1.d5818dcfba487p0, 0x1.2ed02d75b3707p-55},
    {0x1.dfc97337b9b5fp0, -0x1.1a5cd4f184b5cp-54},
    {0x1.ea4afa2a490dap0, -0x1.e9c23179c2893p-54},
    {0x1.f50765b6e454p0, 0x1.9d3e12dd8a18bp-54},
}};

/// ln(i/64) for i = 45 ... 91.
constexpr std::size_t first_logarithm = 45;
constexpr std::array<DoubleDouble, 47> logarithms{{
    {-0x1.68ac83e9c6a14p-2, -0x1.a64eadd740178p-58}, {-0x1.522ae0738a3d8p-2, 0x1.8f7e9b38a6979p-57},
    {-0x1.3c25277333184p-2, 0x1.2ad27e50a8ec6p-56},  {-0x1.269621134db92p-2, -0x1.e0efadd9db02bp-56},
    {-0x1.1178e8227e47cp-2, 0x1.0e63a5f01c691p-57},  {-0x1.f991c6cb3b379p-3, -0x1.f665066f980a2p-57},
    {-0x1.d1037f2655e7bp-3, -0x1.60629242471a2p-57}, {-0x1.a93ed3c8ad9e3p-3, -0x1.bcafa9de97203p-57},
    {-0x1.823c16551a3c2p-3, 0x1.1232ce70be781p-57},  {-0x1.5bf406b543db2p-3, 0x1.1f5b44c0df7e7p-61},
    {-0x1.365fcb0159016p-3, -0x1.7d411a5b944adp-58}, {-0x1.1178e8227e47cp-3, 0x1.0e63a5f01c691p-58},
    {-0x1.da727638446a2p-4, -0x1.401fa71733019p-58}, {-0x1.9335e5d594989p-4, 0x1.478a85704ccb7p-58},
    {-0x1.4d3115d207eacp-4, -0x1.769f42c7842ccp-58}, {-0x1.08598b59e3a07p-4, 0x1.dd7009902bf32p-58},
    {-0x1.894aa149fb343p-5, -0x1.a8be97660a23dp-60}, {-0x1.0415d89e74444p-5, -0x1.c05cf1d753622p-59},
    {-0x1.0205658935847p-6, -0x1.27c8e8416e71fp-60}, {0.0, 0.0},
    {0x1.fc0a8b0fc03e4p-7, -0x1.83092c59642a1p-62},  {0x1.f829b0e7833p-6, 0x1.33e3f04f1ef23p-60},
    {0x1.77458f632dcfcp-5, 0x1.18d3ca87b9296p-59},   {0x1.f0a30c01162a6p-5, 0x1.85f325c5bbacdp-59},
    {0x1.341d7961bd1d1p-4, -0x1.b599f227becbbp-58},  {0x1.6f0d28ae56b4cp-4, -0x1.906d99184b992p-58},
    {0x1.a926d3a4ad563p-4, 0x1.942f48aa70ea9p-58},   {0x1.e27076e2af2e6p-4, -0x1.61578001e0162p-60},
    {0x1.0d77e7cd08e59p-3, 0x1.9a5dc5e9030acp-57},   {0x1.29552f81ff523p-3, 0x1.301771c407dbfp-57},
    {0x1.44d2b6ccb7d1ep-3, 0x1.9f4f6543e1f88p-57},   {0x1.5ff3070a793d4p-3, -0x1.bc60efafc6f6ep-58},
    {0x1.7ab890210d909p-3, 0x1.be36b2d6a0608p-59},   {0x1.9525a9cf456b4p-3, 0x1.d904c1d4e2e26p-57},
    {0x1.af3c94e80bff3p-3, -0x1.398cff3641985p-58},  {0x1.c8ff7c79a9a22p-3, -0x1.4f689f8434012p-57},
    {0x1.e27076e2af2e6p-3, -0x1.61578001e0162p-59},  {0x1.fb9186d5e3e2bp-3, -0x1.caaae64f21acbp-57},
    {0x1.0a324e27390e3p-2, 0x1.7dcfde8061c03p-56},   {0x1.1675cababa60ep-2, 0x1.ce63eab883717p-61},
    {0x1.22941fbcf7966p-2, -0x1.76f5eb09628afp-56},  {0x1.2e8e2bae11d31p-2, -0x1.8f4cdb95ebdf9p-56},
    {0x1.3a64c556945eap-2, -0x1.c68651945f97cp-57},  {0x1.4618bc21c5ec2p-2, 0x1.f42decdeccf1dp-56},
    {0x1.51aad872df82dp-2, 0x1.3927ac19f55e3p-59},   {0x1.5d1bdbf5809cap-2, 0x1.4236383dc7fe1p-56},
    {0x1.686c81e9b14afp-2, -0x1.ddea0f7f58e3dp-57},
}};

/// ln(2), the first part with so few bits that its product with an exponent is exact.
constexpr DoubleDouble ln2{0x1.62e42fefa3p-1, 0x1.3de6af278ece6p-42};

/// Beyond +-this every power overflows or vanishes.
constexpr double out_of_reach = 800.0;

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

/// e^x, within 0.51 ulp (plus one more rounding where the result is subnormal). Pre: |x| <= out_of_reach.
double exponential(DoubleDouble x) {
  // x = n ln(2)/32 + r, |r| < 0.011; ln(2)/32 in three parts, the products with the first two exact.
  const double n = nearest_integer(x.hi * 0x1.71547652b82fep5);
  const DoubleDouble near = two_sum(x.hi - n * 0x1.62e42fefap-6, -n * 0x1.cf79abc9ep-45);
  const DoubleDouble r = quick_two_sum(near.hi, near.lo + (x.lo - n * 0x1.d9cc01f97b57ap-84));
  double series = 1.0 / 5040.0 + r.hi / 40320.0;
  series = 1.0 / 720.0 + r.hi * series;
  series = 1.0 / 120.0 + r.hi * series;
  series = 1.0 / 24.0 + r.hi * series;
  series = 1.0 / 6.0 + r.hi * series;
  series = 0.5 + r.hi * series;
  const double growth = r.hi + (r.lo + r.hi * r.hi * series);

  const int thirty_seconds = static_cast<int>(n);
  const int exponent = thirty_seconds >> 5;
  const DoubleDouble power = powers_of_two[static_cast<std::size_t>(thirty_seconds & 31)];
  const double fraction = power.hi + (power.lo + power.hi * growth);
  const int half = exponent / 2;  // in two steps, as 2^exponent alone may be out of range
  return fraction * power_of_two(half) * power_of_two(exponent - half);
}

/// ln(x), relative error below 2^-67. Pre: x is positive and finite.
DoubleDouble logarithm(double x) {
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    exponent = -54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> 52U) - 1023;
  double m = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFU) | 0x3FF0000000000000U);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  // ln(m) = ln(c) + 2 artanh(s) with c = i/64 the nearest of the table and s = (m - c)/(m + c), |s| < 2^-7.
  const double sixty_fourths = nearest_integer(64.0 * m);
  const double c = sixty_fourths / 64.0;
  const DoubleDouble s = DoubleDouble{m - c, 0.0} / two_sum(m, c);
  const double z = s.hi * s.hi;
  const double series = z * (2.0 / 3.0 + z * (2.0 / 5.0 + z * (2.0 / 7.0 + z * (2.0 / 9.0))));
  const DoubleDouble artanh_twice = quick_two_sum(2.0 * s.hi, 2.0 * s.lo + s.hi * series);

  const DoubleDouble ln_c = logarithms[static_cast<std::size_t>(sixty_fourths) - first_logarithm];
  const DoubleDouble known = two_sum(exponent * ln2.hi, ln_c.hi);
  return artanh_twice + quick_two_sum(known.hi, known.lo + (ln_c.lo + exponent * ln2.lo));
}

/// The logarithm of any x in the base whose 1/ln is `scale`.
double logarithm_in_base(double x, DoubleDouble scale) {
  if (std::isnan(x) || x < 0.0) return nan;
  if (x == 0.0) return -infinity;
  return std::isinf(x) ? x : (logarithm(x) * scale).hi;
}

bool is_odd_integer(double x) {
  return std::abs(x) < 0x1p53 && x == std::floor(x) && 0.5 * x != std::floor(0.5 * x);
}

/// |base|^exponent. Pre: neither is NaN, exponent is not 0.
double power_of_magnitude(double base, double exponent) {
  if (base == 1.0) return 1.0;
  if (base == 0.0 || std::isinf(base) || std::isinf(exponent)) {
    return (base > 1.0) == (exponent > 0.0) ? infinity : 0.0;
  }
  const DoubleDouble ln_base = logarithm(base);
  const double estimate = ln_base.hi * exponent;
  if (std::abs(estimate) > out_of_reach) return estimate > 0.0 ? infinity : 0.0;
  return exponential(ln_base * exponent);
}

}  // namespace

double exp(double x) {
  if (std::isnan(x)) return nan;
  if (std::abs(x) > out_of_reach) return x > 0.0 ? infinity : 0.0;
  return exponential({x, 0.0});
}

double log(double x) {
  return logarithm_in_base(x, {1.0, 0.0});
}

double log2(double x) {
  return logarithm_in_base(x, {0x1.71547652b82fep0, 0x1.777d0ffda0d24p-56});
}

double log10(double x) {
  return logarithm_in_base(x, {0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57});
}

double pow(double base, double exponent) {
  if (exponent == 0.0 || base == 1.0) return 1.0;
  if (std::isnan(base) || std::isnan(exponent)) return nan;
  if (exponent == 2.0) return base * base;  // by far the commonest, and correctly rounded
  const bool whole_exponent = std::isinf(exponent) || exponent == std::floor(exponent);
  if (base < 0.0 && std::isfinite(base) && !whole_exponent) return nan;
  const double magnitude = power_of_magnitude(std::abs(base), exponent);
  return std::signbit(base) && is_odd_integer(exponent) ? -magnitude : magnitude;
}

double cbrt(double x) {
  if (x == 0.0 || !std::isfinite(x)) return x;
  constexpr DoubleDouble third{0x1.5555555555555p-2, 0x1.5555555555555p-56};
  return std::copysign(exponential(logarithm(std::abs(x)) * third), x);
}

double hypot(double x, double y) {
  x = std::abs(x);
  y = std::abs(y);
  if (std::isinf(x) || std::isinf(y)) return infinity;
  if (std::isnan(x) || std::isnan(y)) return nan;
  if (x < y) std::swap(x, y);
  if (x * 0x1p-60 >= y) return x;  // x = 0 too
  const double scale = x > 0x1p400 ? 0x1p-640 : x < 0x1p-300 ? 0x1p700 : 1.0;
  const DoubleDouble length = square_root(two_product(x * scale, x * scale) + two_product(y * scale, y * scale));
  return length.hi / scale;
}

}  // namespace burin::math
