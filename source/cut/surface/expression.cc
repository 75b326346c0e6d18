// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/cut/surface/expression.h>

#include <cctype>
#include <iostream>
#include <sstream>
#include <vector>
namespace Setsudan
{
using namespace dealii;

namespace
{
/** While it lives, what goes to standard error is kept instead: deal.II prints
 * there why an expression does not parse, and throws without saying it. */
class CapturedErrors
{
public:
  CapturedErrors()
    : original(std::cerr.rdbuf(captured.rdbuf()))
  {
  }

  ~CapturedErrors()
  {
    std::cerr.rdbuf(original);
  }

  /** muParser's reason, out of "Message:  <reason>". */
  std::string
  reason() const
  {
    const std::string text = captured.str();
    const auto begin       = text.find("Message:  <");
    const auto end         = text.find(">\n", begin);
    return begin == std::string::npos || end == std::string::npos
             ? "it does not parse"
             : text.substr(begin + 11, end - begin - 11);
  }

private:
  std::ostringstream captured;
  std::streambuf *const original;
};

/** Whether the '=' at a place is an assignment, and no part of a comparison. */
bool
is_assignment(const std::string &text, const std::size_t position)
{
  const std::string before = "<>=!";
  return text[position] == '=' &&
         (position == 0 || before.find(text[position - 1]) == before.npos) &&
         (position + 1 == text.size() || text[position + 1] != '=');
}

/** Where muParser takes more than one expression, in words; nothing where it
 * does not. Commas separate the arguments of a function, whose name stands
 * before the parenthesis. */
std::string
second_expression(const std::string &text)
{
  std::vector<bool> is_call;
  char last = ' ';
  for (std::size_t i = 0; i < text.size(); ++i)
    {
      const char c = text[i];
      if (is_assignment(text, i))
        return "'=' assigns a value; write an expression that is 0 on the cut, "
               "such as 'y - 2' for 'y = 2'";
      if (c == ',' && (is_call.empty() || !is_call.back()))
        return "',' separates expressions, of which there can be one; a "
               "decimal "
               "sign is a point";
      if (c == '(')
        is_call.push_back(std::isalnum(static_cast<unsigned char>(last)) != 0 ||
                          last == '_');
      if (c == ')' && !is_call.empty())
        is_call.pop_back();
      if (c != ' ')
        last = c;
    }
  return "";
}
} // namespace


template <int dim>
Expression<dim>::Expression(const std::string &variables,
                            const std::string &text)
  : parser(std::make_shared<FunctionParser<dim>>())
  , what_is_wrong(second_expression(text))
  , has_comparison(text.find_first_of("<>=&|") != std::string::npos)
{
  if (!what_is_wrong.empty())
    return;
  const CapturedErrors errors;
  try
    {
      parser->initialize(variables, text, {});
      parser->value(Point<dim>());
    }
  catch (const std::exception &)
    {
      what_is_wrong = errors.reason();
    }
}



template <int dim>
const std::string &
Expression<dim>::problem() const
{
  return what_is_wrong;
}



template <int dim>
bool
Expression<dim>::compares() const
{
  return has_comparison;
}



template <int dim>
double
Expression<dim>::operator()(const Point<dim> &point) const
{
  return parser->value(point);
}



template class Expression<2>;
template class Expression<3>;
} // namespace Setsudan
