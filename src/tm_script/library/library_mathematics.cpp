// Mathematics. Angles are radians.
#include <cmath>

#include "library/library.h"
#include "values/conversion.h"

#include "cobot_command/common/units.h"

namespace cobot_command::tm_script {

namespace {

using OfOne = double (*)(double);

Builtin ofDouble(OfOne compute) {
  return
      [=](const Arguments& arguments) -> Computed { return Scalar(compute(scalarAt<double>(arguments, 0))); };
}

/// Computed as a double, given as the type of the argument.
template <class Real>
Builtin ofReal(OfOne compute) {
  return [=](const Arguments& arguments) -> Computed {
    return Scalar(static_cast<Real>(compute(scalarAt<Real>(arguments, 0))));
  };
}

/// To a whole number, which must be one of an int.
Builtin rounded(OfOne compute) {
  return [=](const Arguments& arguments) -> Computed {
    auto number = convert(Scalar(compute(scalarAt<double>(arguments, 0))), ScalarType::Int);
    if (!number) return refuse(std::move(number.error()));
    return std::move(*number);
  };
}

template <class Number>
Computed power(const Arguments& arguments) {
  const double result =
      std::pow(static_cast<double>(scalarAt<Number>(arguments, 0)), scalarAt<double>(arguments, 1));
  auto number = convert(Scalar(result), typeOf(Scalar(Number{})));
  if (!number) return refuse(std::move(number.error()));
  return std::move(*number);
}

double absolute(double number) {
  return std::abs(number);
}

Computed absoluteInteger(const Arguments& arguments) {
  const auto number = static_cast<std::uint32_t>(intAt(arguments, 0, 0));
  return Scalar(static_cast<std::int32_t>(intAt(arguments, 0, 0) < 0 ? 0U - number : number));
}

}  // namespace

void defineMathematics(FunctionTable& table) {
  table.define("int abs(int)", kSinceEver, absoluteInteger);
  table.define("float abs(float)", kSinceEver, ofReal<float>(absolute));
  table.define("double abs(double)", kSinceEver, ofReal<double>(absolute));
  table.define("int pow(int, double)", kSinceEver, power<std::int32_t>);
  table.define("float pow(float, double)", kSinceEver, power<float>);
  table.define("double pow(double, double)", kSinceEver, power<double>);
  table.define("float sqrt(float)", kSinceEver, ofReal<float>([](double x) { return std::sqrt(x); }));
  table.define("double sqrt(double)", kSinceEver, ofReal<double>([](double x) { return std::sqrt(x); }));
  table.define("int ceil(double)", kSinceEver, rounded([](double x) { return std::ceil(x); }));
  table.define("int floor(double)", kSinceEver, rounded([](double x) { return std::floor(x); }));
  table.define("int round(double)", kSinceEver, rounded([](double x) { return std::round(x); }));
  table.define("double d2r(double)", kSinceEver, ofDouble([](double x) { return degToRad(x); }));
  table.define("double r2d(double)", kSinceEver, ofDouble([](double x) { return radToDeg(x); }));
  table.define("double sin(double)", kSinceEver, ofDouble([](double x) { return std::sin(x); }));
  table.define("double cos(double)", kSinceEver, ofDouble([](double x) { return std::cos(x); }));
  table.define("double tan(double)", kSinceEver, ofDouble([](double x) { return std::tan(x); }));
  table.define("double asin(double)", kSinceEver, ofDouble([](double x) { return std::asin(x); }));
  table.define("double acos(double)", kSinceEver, ofDouble([](double x) { return std::acos(x); }));
  table.define("double atan(double)", kSinceEver, ofDouble([](double x) { return std::atan(x); }));
  table.define("double log(double)", kSinceEver, ofDouble([](double x) { return std::log(x); }));
  table.define("double log10(double)", kSinceEver, ofDouble([](double x) { return std::log10(x); }));
  table.define("double atan2(double, double)", kSinceEver, [](const Arguments& arguments) -> Computed {
    return Scalar(std::atan2(scalarAt<double>(arguments, 0), scalarAt<double>(arguments, 1)));
  });
}

}  // namespace cobot_command::tm_script
