// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file nearest_first.h
/// Intersect_BBox_Tree() with a stack where that has a queue: of a node's children the nearest is followed
/// at once, and boxes that begin behind what was found are never looked at. It finds the same nearest
/// intersection; of two at exactly the same depth it may be the other one, which is why only pictures with
/// `tilt_lens` use it: all others stay bit for bit what they are without this project.

#ifndef NEAREST_FIRST_H
#define NEAREST_FIRST_H

#include "backend/frame.h"
#include "backend/bounding/bbox.h"

namespace pov
{

/// @param stack  scratch memory; what it holds is of no meaning before and after
/// @param best   intersections nearer than its depth are looked for; set to the nearest
/// @return       whether there is one
bool IntersectNearestFirst(PriorityQueue& stack, const BBOX_TREE* root, const Ray& ray, Intersection* best,
                           TraceThreadData* thread);

/// The same among objects and intersections that fulfil the conditions.
bool IntersectNearestFirst(PriorityQueue& stack, const BBOX_TREE* root, const Ray& ray, Intersection* best,
                           const RayObjectCondition& precondition, const RayObjectCondition& postcondition,
                           TraceThreadData* thread);

} // namespace pov

#endif
