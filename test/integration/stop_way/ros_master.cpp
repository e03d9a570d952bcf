#include "ros_master.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <ros/init.h>
#include <ros/master.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cobot_command::testing {
namespace {

int freePort() {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  EXPECT_EQ(::bind(listener, any, size), 0);
  EXPECT_EQ(::getsockname(listener, any, &size), 0);
  ::close(listener);
  return ntohs(address.sin_port);
}

pid_t run(const std::string& port) {
  const pid_t process = ::fork();
  if (process == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::execl("/usr/bin/rosmaster", "rosmaster", "--core", "-p", port.c_str(), nullptr);
    ::_exit(127);
  }
  return process;
}

class Environment : public ::testing::Environment {
  void SetUp() override { RosMaster::instance().start(); }
  void TearDown() override { RosMaster::instance().stop(); }
};
const auto* const environment = ::testing::AddGlobalTestEnvironment(new Environment);

}  // namespace

RosMaster& RosMaster::instance() {
  static RosMaster master;
  return master;
}

void RosMaster::start() {
  const std::string port = std::to_string(freePort());
  const std::string folder = (std::filesystem::temp_directory_path() / ("ros_" + port)).string();
  ::setenv("ROS_MASTER_URI", ("http://localhost:" + port).c_str(), 1);
  ::setenv("ROS_HOSTNAME", "localhost", 1);
  ::setenv("ROS_HOME", folder.c_str(), 1);
  ::setenv("ROS_LOG_DIR", folder.c_str(), 1);
  process_ = run(port);
  ros::init(ros::M_string(), "tested", ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
  ASSERT_TRUE(process_ > 0);
  ros::start();  // waits for the master
}

void RosMaster::stop() {
  ros::shutdown();
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  std::error_code ignored;
  std::filesystem::remove_all(std::getenv("ROS_HOME"), ignored);
}

void RosMaster::hang() {
  ::kill(process_, SIGSTOP);
}

void RosMaster::goOn() {
  ::kill(process_, SIGCONT);
}

}  // namespace cobot_command::testing
