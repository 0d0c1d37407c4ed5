#pragma once

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "privileges.hpp"

namespace mrroc::links {

/// Runs iproute2 in the network namespace of the caller.
inline void ip(const std::string& arguments) {
  if (std::system(("PATH=$PATH:/usr/sbin:/sbin; ip " + arguments).c_str()) != 0) {
    throw std::runtime_error("ip " + arguments);
  }
}

/// Runs `body()` in a child process with its own network namespace, in which only the loopback device exists and is up.
/// The child is root there; an ordinary user gets this with a user namespace. Failures in the child fail the calling
/// test.
template <class Body>
void in_own_network(Body body) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    try {
      test::enter_own_network();
      body();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    std::fflush(nullptr);
    ::_exit(::testing::Test::HasFailure() ? 1 : 0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << "in the child process";
}

}  // namespace mrroc::links
