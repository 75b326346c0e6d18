// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>

namespace Setsudan
{
/** The user's mistake; the message says where it was written, and what is
 * allowed. */
class SceneError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** A body's file cannot be used; the message says what is wrong with it. */
class BodyFileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** A solve did not fulfil its equations; the message says which and why. */
class SolverError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** A matrix that is to be positive definite is not. */
class NotDefiniteError : public SolverError
{
public:
  using SolverError::SolverError;
};

/** There is no stable equilibrium: a result, with which a run ends. The message
 * says where the body gives way. */
class NoEquilibriumError : public SolverError
{
public:
  using SolverError::SolverError;
};

/** A state does not obey what holds in all states, as the balance of forces;
 * the message has the numbers. */
class InvariantError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** A cut cannot go on, for what the scene asks of the body that it leaves; the
 * message says what to change. */
class CutError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** A piece has lost its support, and what it carries or the blade would move it
 * away. */
class FloatingPieceError : public CutError
{
public:
  using CutError::CutError;
};

/** A file cannot be written. */
class OutputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The run was stopped from outside. */
class RunInterrupted : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace Setsudan
