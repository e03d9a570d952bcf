#include "script_port/controller_functions.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "robot/controller_clock.h"
#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

using tm_script::Arguments;
using tm_script::Scalar;
using tm_script::Value;
using Computed = Result<Value, std::string>;

constexpr tm_script::Version kSinceEver{1, 68};

template <class T>
const T& scalarAt(const Arguments& arguments, std::size_t place) {
  return std::get<T>(std::get<Scalar>(arguments[place]));
}

/// Of the project's run [ms].
std::int64_t stampOf(const RobotState& state) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(state.time - state.project_started).count();
}

}  // namespace

void defineControllerFunctions(tm_script::FunctionTable& functions,
                               const std::function<RobotState()>& state) {
  // The engine's numbers are fixed by the standard; those of its distributions are not.
  const auto engine = std::make_shared<std::mt19937>();
  functions.define("float random()", kSinceEver, [engine](const Arguments&) -> Computed {
    constexpr float kSteps = 16777216.0F;  // 24 bits, which a float has
    return Scalar(static_cast<float>((*engine)() >> 8) / kSteps);
  });
  functions.define("int random(int, int)", kSinceEver, [engine](const Arguments& arguments) -> Computed {
    const std::int64_t least = scalarAt<std::int32_t>(arguments, 0),
                       most = scalarAt<std::int32_t>(arguments, 1);
    if (least > most) return refuse(fmt::format("there is no integer from {} to {}", least, most));
    const auto count = static_cast<std::uint64_t>(most - least + 1);
    return Scalar(static_cast<std::int32_t>(least + static_cast<std::int64_t>((*engine)() % count)));
  });
  functions.define("string GetNow(string?)", kSinceEver, [state](const Arguments& arguments) -> Computed {
    const std::string format =
        arguments.empty() ? "MM/dd/yyyy HH:mm:ss" : scalarAt<std::string>(arguments, 0);
    return Scalar(clockText(state().time, format));
  });
  functions.define("int GetNowStamp()", kSinceEver, [state](const Arguments&) -> Computed {
    return Scalar(static_cast<std::int32_t>(stampOf(state())));
  });
  functions.define("double GetNowStamp(bool)", kSinceEver, [state](const Arguments&) -> Computed {
    return Scalar(static_cast<double>(stampOf(state())));
  });
}

}  // namespace cobot_command::simulator
