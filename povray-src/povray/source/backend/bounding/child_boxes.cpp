// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/bounding/child_boxes.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

FourBoxes FourOf(BBOX_TREE* const* children, int count)
{
    FourBoxes boxes = {};
    for (int i = 0; i < count; i++)
    {
        (children[i]->Infinite ? boxes.infinite : boxes.finite) |= 1u << i;
        boxes.tested += children[i]->Infinite ? 0 : 1;
        for (int axis = X; axis <= Z; axis++)
        {
            boxes.lowerLeft[axis][i] = children[i]->BBox.Lower_Left[axis];
            boxes.lengths[axis][i] = children[i]->BBox.Lengths[axis];
        }
    }
    return boxes;
}

} // namespace

void GatherChildBoxes(BBOX_TREE* node)
{
    if (node == NULL || node->Entries == 0)
        return;
    const int children = node->Entries, fours = (children + 3) / 4;
    node->Node = reinterpret_cast<BBOX_TREE**>(
        POV_REALLOC(node->Node, BoxesBehind(children) + fours * sizeof(FourBoxes), "bounding boxes of children"));
    FourBoxes* const boxes = const_cast<FourBoxes*>(BoxesOf(node));
    for (int i = 0; i < fours; i++)
        boxes[i] = FourOf(node->Node + 4 * i, std::min(4, children - 4 * i));
    for (int i = 0; i < children; i++)
        GatherChildBoxes(node->Node[i]);
}

} // namespace pov
