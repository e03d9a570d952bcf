#include <algorithm>
#include <array>
#include <cerrno>

#include "system_error.h"
#include <boost/asio/error.hpp>

namespace cobot_command::transport {
namespace {

using boost::system::error_code;

struct Row {
  error_code code;
  NetworkError::Kind kind;
};

const auto& rows() {
  namespace error = boost::asio::error;
  using Kind = NetworkError::Kind;
  const auto& system = boost::system::system_category();
  static const std::array<Row, 14> table{{
      {error::connection_refused, Kind::Refused},
      {error::connection_reset, Kind::Refused},
      {error::network_unreachable, Kind::Unreachable},
      {error::network_down, Kind::Unreachable},
      {error::host_unreachable, Kind::Unreachable},
      {error_code(ENOLINK, system), Kind::Unreachable},
      {error::host_not_found, Kind::UnknownHost},
      {error::host_not_found_try_again, Kind::UnknownHost},
      {error::no_data, Kind::UnknownHost},
      {error::no_recovery, Kind::UnknownHost},
      {error::timed_out, Kind::TimedOut},
      {error::address_in_use, Kind::AddressInUse},
      {error_code(EADDRNOTAVAIL, system), Kind::BadAddress},
      {error::invalid_argument, Kind::BadAddress},
  }};
  return table;
}

}  // namespace

NetworkError toNetworkError(const error_code& code) {
  const auto row = std::find_if(rows().begin(), rows().end(), [&](const Row& r) { return r.code == code; });
  return {row == rows().end() ? NetworkError::Kind::Other : row->kind, code.message()};
}

}  // namespace cobot_command::transport
