#include "mrroc/condition.hpp"

namespace mrroc {

Both::Both(std::shared_ptr<Condition> a, std::shared_ptr<Condition> b)
    : Condition(a->name() + " and " + b->name()), a_(std::move(a)), b_(std::move(b)) {}

void Both::start() {
  a_->start();
  b_->start();
}

bool Both::holds() {
  const bool a = a_->evaluate();
  const bool b = b_->evaluate();
  return a && b;
}

void Both::append_leaves(std::vector<const Condition*>& leaves) const {
  a_->append_leaves(leaves);
  b_->append_leaves(leaves);
}

void Both::append_reasons(std::vector<const Condition*>& reasons) const {
  if (renamed()) reasons.push_back(this);
  a_->append_reasons(reasons);
  b_->append_reasons(reasons);
}

Either::Either(std::shared_ptr<Condition> a, std::shared_ptr<Condition> b)
    : Condition(a->name() + " or " + b->name()), a_(std::move(a)), b_(std::move(b)) {}

void Either::start() {
  a_->start();
  b_->start();
}

bool Either::holds() {
  const bool a = a_->evaluate();
  const bool b = b_->evaluate();
  return a || b;
}

void Either::append_leaves(std::vector<const Condition*>& leaves) const {
  a_->append_leaves(leaves);
  b_->append_leaves(leaves);
}

void Either::append_reasons(std::vector<const Condition*>& reasons) const {
  if (renamed()) reasons.push_back(this);
  if (a_->value()) a_->append_reasons(reasons);
  if (b_->value()) b_->append_reasons(reasons);
}

Negated::Negated(std::shared_ptr<Condition> a) : Condition("not (" + a->name() + ")"), a_(std::move(a)) {}

void Negated::start() { a_->start(); }

bool Negated::holds() { return !a_->evaluate(); }

void Negated::append_leaves(std::vector<const Condition*>& leaves) const { a_->append_leaves(leaves); }

}  // namespace mrroc
