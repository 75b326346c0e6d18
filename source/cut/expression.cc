#include <setsudan/cut/expression.h>

#include <iostream>
#include <sstream>

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
} // namespace


template <int dim>
Expression<dim>::Expression(const std::string &variables,
                            const std::string &text)
  : parser(std::make_shared<FunctionParser<dim>>())
{
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
double
Expression<dim>::operator()(const Point<dim> &point) const
{
  return parser->value(point);
}



template class Expression<2>;
template class Expression<3>;
} // namespace Setsudan
