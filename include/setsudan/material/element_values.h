// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/body.h>
#include <setsudan/parameters/parameters.h>

#include <string>
#include <utility>
#include <vector>

namespace Setsudan
{
/** A value for each element, or one for all of them. */
template <typename Value>
using ElementValues = std::vector<Value>;

/**
 * Read a parameter of subsection `Material` that is a number, or numbers for
 * groups of elements.
 *
 * @param is_allowed what a number must fulfil, and `allowed` says.
 * @throw SceneError for another one, or a group that the body does not have.
 */
template <int dim>
ElementValues<double>
read_numbers(const Parameters &parameters,
             const Body<dim> &body,
             const std::string &name,
             const std::string &allowed,
             bool (*is_allowed)(double));

/** Numbers that are given together, separated by ','. */
struct NumberList
{
  /** What they are, in words. */
  std::string kind;
  unsigned int n_numbers;
  /** What each must fulfil, in words behind their number. */
  std::string allowed;
  bool (*is_allowed)(double);
  /** Whether a list may be empty, and is where groups leave elements out. */
  bool may_be_empty = false;
};

/** The same of such lists. */
template <int dim>
ElementValues<std::vector<double>>
read_lists(const Parameters &parameters,
           const Body<dim> &body,
           const std::string &name,
           const NumberList &list);

/** The same of pairs of numbers 'first : second', separated by ','; they may be
 * none.
 *
 * @param kind what a pair is, in words. */
template <int dim>
ElementValues<std::vector<std::pair<double, double>>>
read_pairs(const Parameters &parameters,
           const Body<dim> &body,
           const std::string &name,
           const std::string &kind,
           const std::string &allowed,
           bool (*is_allowed)(const std::pair<double, double> &));

/** The same of names.
 *
 * @param kind of what they are the names of.
 * @param names those that are allowed, separated by '|'. */
template <int dim>
ElementValues<std::string>
read_names(const Parameters &parameters,
           const Body<dim> &body,
           const std::string &name,
           const std::string &kind,
           const std::string &names);
} // namespace Setsudan
