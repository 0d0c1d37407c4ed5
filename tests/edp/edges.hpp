#pragma once

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>

namespace mrroc::edp {

/// Transitions of a state machine and how often each was observed.
template <class State>
using Edges = std::map<std::pair<State, State>, int>;

template <class State>
using EdgeTable = std::set<std::pair<State, State>>;

/// Expects that the observed transitions are those of the table: every one, and no other.
template <class State>
void expect_all_of(const Edges<State>& observed, const EdgeTable<State>& table) {
  const auto name = [](const auto& edge) {
    return std::to_string(static_cast<int>(edge.first)) + " -> " + std::to_string(static_cast<int>(edge.second));
  };
  for (const auto& [edge, times] : observed) EXPECT_TRUE(table.contains(edge)) << name(edge) << " is not in the table";
  for (const auto& edge : table) EXPECT_TRUE(observed.contains(edge)) << name(edge) << " was not observed";
}

}  // namespace mrroc::edp
