#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace mrroc {

/// f_I or f_T: a named predicate over the states of robots and sensors. Derive from it, keep references to the robots
/// and sensors that it reads, and implement `holds()`. Conditions are values: they combine with `&&`, `||`, `!`, and
/// are given to `Wait` or to a generator with `.until(...)`. Every part is evaluated exactly once per step (no short
/// circuit). Task's thread only.
class Condition {
 public:
  explicit Condition(std::string name) : name_(std::move(name)) {}
  virtual ~Condition() = default;

  const std::string& name() const noexcept { return name_; }
  void rename(std::string name) {
    name_ = std::move(name);
    renamed_ = true;
  }

  /// Called once per instruction, after e^{i0}, v^{i0} have arrived and before the first evaluation. May allocate.
  virtual void start() {}
  /// Evaluates, stores and returns the value. Once per step; must not allocate.
  bool evaluate() { return value_ = holds(); }
  /// The last evaluated value.
  bool value() const noexcept { return value_; }

  /// Appends the leaves (the parts that are not combinations), left to right: the columns of a trace.
  virtual void append_leaves(std::vector<const Condition*>& leaves) const { leaves.push_back(this); }
  /// Appends the parts whose value made this one hold; called when `value()` is true.
  virtual void append_reasons(std::vector<const Condition*>& reasons) const { reasons.push_back(this); }

 protected:
  Condition(const Condition&) = default;
  Condition(Condition&&) = default;
  Condition& operator=(const Condition&) = default;
  Condition& operator=(Condition&&) = default;

  /// Whether the name was given by `named`, not composed: then a combination is also a reason, in addition to its
  /// parts.
  bool renamed() const noexcept { return renamed_; }
  /// The predicate f(c^i, e^i, v^i).
  virtual bool holds() = 0;

 private:
  std::string name_;
  bool value_ = false;
  bool renamed_ = false;
};

template <class C>
concept ConditionType = std::derived_from<C, Condition> && std::copy_constructible<C>;

/// A condition from a function: When{"part seen", [&] { return gate.distance() < 0.1; }}.
class When : public Condition {
 public:
  When(std::string name, std::function<bool()> predicate)
      : Condition(std::move(name)), predicate_(std::move(predicate)) {}

 protected:
  bool holds() override { return predicate_(); }

 private:
  std::function<bool()> predicate_;
};

/// Gives a condition its own name: named("left contact", ForceAbove{left, 10}). A named combination is found by
/// `Outcome::by(name)` like any other.
template <ConditionType C>
C named(std::string name, C condition) {
  condition.rename(std::move(name));
  return condition;
}

/// `a && b`.
class Both : public Condition {
 public:
  Both(std::shared_ptr<Condition> a, std::shared_ptr<Condition> b);
  void start() override;
  void append_leaves(std::vector<const Condition*>& leaves) const override;
  void append_reasons(std::vector<const Condition*>& reasons) const override;

 protected:
  bool holds() override;

 private:
  std::shared_ptr<Condition> a_, b_;
};

/// `a || b`.
class Either : public Condition {
 public:
  Either(std::shared_ptr<Condition> a, std::shared_ptr<Condition> b);
  void start() override;
  void append_leaves(std::vector<const Condition*>& leaves) const override;
  void append_reasons(std::vector<const Condition*>& reasons) const override;

 protected:
  bool holds() override;

 private:
  std::shared_ptr<Condition> a_, b_;
};

/// `!a`. It is its own reason: the instruction ended because `a` did not hold.
class Negated : public Condition {
 public:
  explicit Negated(std::shared_ptr<Condition> a);
  void start() override;
  void append_leaves(std::vector<const Condition*>& leaves) const override;

 protected:
  bool holds() override;

 private:
  std::shared_ptr<Condition> a_;
};

template <ConditionType A, ConditionType B>
Both operator&&(A a, B b) {
  return {std::make_shared<A>(std::move(a)), std::make_shared<B>(std::move(b))};
}

template <ConditionType A, ConditionType B>
Either operator||(A a, B b) {
  return {std::make_shared<A>(std::move(a)), std::make_shared<B>(std::move(b))};
}

template <ConditionType A>
Negated operator!(A a) {
  return Negated{std::make_shared<A>(std::move(a))};
}

}  // namespace mrroc
