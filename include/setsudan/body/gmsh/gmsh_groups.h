// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <setsudan/body/gmsh/gmsh_outline.h>
#include <setsudan/body/group.h>

#include <map>
#include <vector>

namespace Setsudan
{
/** The cells in each of gmsh's geometrical entities, ascending: groups consist
 * of entities. */
using CellsOfEntities = std::map<int, std::vector<unsigned int>>;

/**
 * Check how often a file of version 2.2 lists the elements of an entity: each
 * must appear once for every group that the entity is in. gmsh puts all
 * elements of an entity in the groups of each, right or wrong.
 *
 * @param n_listed, n_distinct how many elements there are, with and without
 * repetitions.
 * @throw std::runtime_error where elements of the entity are in different
 * groups, as gmsh cannot tell them apart.
 */
void
check_repetitions(const unsigned int dimension,
                  const int entity,
                  const std::size_t n_listed,
                  const std::size_t n_distinct);

/** Whether elements of an entity may be listed repeatedly. */
bool
can_have_repetitions(const GmshOutline &outline,
                     const unsigned int dimension,
                     const int entity);

/**
 * The physical groups of the file that gmsh has open, by dimension and number.
 * Those that only the outline knows are empty. Entities name numbers of nodes.
 *
 * @param cells by the entities of the body's dimension.
 */
std::vector<Group>
load_gmsh_groups(const unsigned int dim,
                 const GmshOutline &outline,
                 const CellsOfEntities &cells);
} // namespace Setsudan
