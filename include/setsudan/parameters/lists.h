// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

// The small grammar of values: lists, lists of `key : value`, numbers.

namespace Setsudan
{
/** A number as people write it: the shortest text that is read as the same. */
std::string
short_text(const double value);

/** The parts of a list, trimmed; empty parts are dropped. */
std::vector<std::string>
split(const std::string &text, const char delimiter);

/**
 * The items `key : value` of a list, keys and values trimmed, in their order.
 * An item without ':' has an empty value.
 */
std::vector<std::pair<std::string, std::string>>
split_items(const std::string &text, const char delimiter);

/** The numbers of a comma-separated list; false where one is not a finite
 * number. */
bool
parse_numbers(const std::string &text, std::vector<double> &values);
} // namespace Setsudan
