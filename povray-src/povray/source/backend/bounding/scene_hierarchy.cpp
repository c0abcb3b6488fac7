// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/bounding/scene_hierarchy.h"

#include <cmath>
#include <mutex>

#include "backend/scene/objects.h"
#include "backend/scene/threaddata.h"
#include "backend/support/statistics.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

using tilt_lens::BoxHierarchy;
using tilt_lens::BoxItem;
using tilt_lens::BoxRay;

/// @param box  its numbers are rounded, its upper corner is a sum: it grows by some such roundings
BoxItem ItemOf(const BBOX& box, const void* what)
{
    BoxItem item;
    for (int axis = X; axis <= Z; axis++)
    {
        const double lower = box.Lower_Left[axis], upper = lower + box.Lengths[axis];
        const double rounding = 2.4e-7 * (std::fabs(lower) + std::fabs(upper));
        item.lower[axis] = lower - rounding;
        item.upper[axis] = upper + rounding;
    }
    item.what = what;
    return item;
}

/// What a light source looks like stands for it.
ObjectPtr Visible(ObjectPtr object)
{
    if (!(object->Type & LIGHT_SOURCE_OBJECT))
        return object;
    const std::vector<ObjectPtr>& children = static_cast<LightSource*>(object)->children;
    return children.empty() ? NULL : children[0];
}

/// Looks for the nearest intersection with an object whose box was met; as Find_Intersection() does, but leaves alone
/// what is not nearer than the best.
/// @param precedes  whether an intersection at the depth of the best takes its place
template<class Condition>
bool FindNearer(ObjectPtr object, bool precedes, const Ray& ray, Intersection& best, TraceThreadData* thread,
                const Condition& condition)
{
    if (!object->Bound.empty() && !Ray_In_Bound(ray, object->Bound, thread))
        return false;
    IStack hits(thread->stackPool);
    bool found = false;
    if (object->All_Intersections(ray, hits, thread))
        for (; !hits->empty(); hits->pop())
        {
            const Intersection& hit = hits->top();
            const bool nearer = hit.Depth < best.Depth || (precedes && !found && hit.Depth == best.Depth);
            if (nearer && (ray.IsSubsurfaceRay() || hit.Depth >= MIN_ISECT_DEPTH) && condition(hit.Depth))
            {
                best = hit;
                found = true;
            }
        }
    return found;
}

void Count(const BoxHierarchy::Count& count, TraceThreadData* thread)
{
    thread->Stats()[nChecked] += count.tested;
    thread->Stats()[nEnqueued] += count.entered;
}

} // namespace

SceneHierarchy::SceneHierarchy(const std::vector<ObjectPtr>& all)
{
    AddMeshes(all);
}

void SceneHierarchy::AddObjects(const std::vector<ObjectPtr>& all)
{
    for (const ObjectPtr each : all)
        if (const ObjectPtr object = Visible(each))
            objects.push_back(object);
    std::vector<BoxItem> items;
    for (const ObjectPtr& object : objects)
        if (Test_Flag(object, INFINITE_FLAG))
            infinite.push_back(&object);
        else
            items.push_back(ItemOf(object->BBox, &object));
    finite.reset(new BoxHierarchy(std::move(items)));
}

void SceneHierarchy::AddMeshes(const std::vector<ObjectPtr>& among)
{
    for (const ObjectPtr object : among)
        AddMeshes(object);
}

void SceneHierarchy::AddMeshes(ObjectPtr object)
{
    Mesh* const mesh = dynamic_cast<Mesh*>(object);
    if (mesh != NULL && mesh->Data->Hierarchy == NULL && mesh->Data->Bounded)
    {
        meshes.push_back(MeshHierarchy::Of(*mesh));
        mesh->Data->Hierarchy = meshes.back().get();
    }
    if (const CompoundObject* const compound = dynamic_cast<const CompoundObject*>(object))
        AddMeshes(compound->children);
    AddMeshes(object->Bound);
    if (object->Clip != object->Bound)
        AddMeshes(object->Clip);
}

template<class FindNearer>
bool SceneHierarchy::Walk(const Ray& ray, Intersection& best, TraceThreadData* thread, const FindNearer& findNearer) const
{
    const ObjectPtr* holder = NULL;
    const auto test = [&](const ObjectPtr* object)
    {
        if (findNearer(*object, holder != NULL && object < holder))
            holder = object;
    };
    for (const ObjectPtr* const object : infinite)
        test(object);
    Count(finite->Walk(BoxRay(ray.Origin, ray.Direction), best.Depth,
                       [&](const void* what) { test(static_cast<const ObjectPtr*>(what)); }), thread);
    return holder != NULL;
}

bool SceneHierarchy::Intersect(const Ray& ray, Intersection& best, TraceThreadData* thread) const
{
    return Walk(ray, best, thread, [&](ObjectPtr object, bool precedes)
    {
        return FindNearer(object, precedes, ray, best, thread, [](DBL) { return true; });
    });
}

bool SceneHierarchy::Intersect(const Ray& ray, Intersection& best, const RayObjectCondition& precondition,
                               const RayObjectCondition& postcondition, TraceThreadData* thread) const
{
    return Walk(ray, best, thread, [&](ObjectPtr object, bool precedes)
    {
        const auto condition = [&](DBL depth) { return postcondition(ray, object, depth); };
        return precondition(ray, object, 0.0) && FindNearer(object, precedes, ray, best, thread, condition);
    });
}

bool MeshHierarchy::MakeTree(const Mesh& mesh)
{
    // one at a time, of whichever mesh
    static std::mutex making;
    const std::lock_guard<std::mutex> lock(making);
    BBOX_TREE* tree = mesh.Data->Tree;
    if (tree == NULL)
    {
        mesh.Make_BBox_Tree(tree);
        __atomic_store_n(&mesh.Data->Tree, tree, __ATOMIC_RELEASE);
    }
    return tree != NULL;
}

std::unique_ptr<BoxHierarchy> MeshHierarchy::Of(Mesh& mesh)
{
    std::vector<BoxItem> items;
    for (long i = 0; i < mesh.Data->Number_Of_Triangles; i++)
    {
        BBOX box;
        mesh.get_triangle_bbox(&mesh.Data->Triangles[i], &box);
        items.push_back(ItemOf(box, &mesh.Data->Triangles[i]));
    }
    return std::unique_ptr<BoxHierarchy>(new BoxHierarchy(std::move(items)));
}

bool MeshHierarchy::Intersect(Mesh& mesh, const Ray& ray, const Ray& worldRay, DBL length, IStack& hits, TraceThreadData* thread)
{
    DBL nearest = BOUND_HUGE;
    bool met = false;
    Count(mesh.Data->Hierarchy->Walk(BoxRay(ray.Origin, ray.Direction), nearest, [&](const void* what)
    {
        const MESH_TRIANGLE* const triangle = static_cast<const MESH_TRIANGLE*>(what);
        DBL depth;
        if (mesh.intersect_mesh_triangle(ray, triangle, &depth) && depth < nearest &&
            mesh.test_hit(triangle, worldRay, depth, length, hits, thread))
        {
            met = true;
            // those who ask may leave a nearer one aside, and of a mesh with an inside all are wanted
            if (!mesh.has_inside_vector && depth > SMALL_TOLERANCE * length)
                nearest = depth;
        }
    }), thread);
    return met;
}

} // namespace pov
