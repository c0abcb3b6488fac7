// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/bounding/scene_hierarchy.h"

#include <cmath>
#include <mutex>

#include "backend/math/vector.h"
#include "backend/scene/objects.h"
#include "backend/scene/threaddata.h"
#include "backend/support/statistics.h"

// must be last
#include "base/povdebug.h"

namespace pov
{

namespace
{

using speedups::BoxHierarchy;
using speedups::BoxItem;
using tilt_lens::Float4;
using tilt_lens::Float8;
using tilt_lens::HasAvx2;

/// Enlarged by a few roundings, since the box is in single precision.
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

/// POV-Ray's INFINITE_FLAG also marks boxes of more than 2e10 cubic units, such as those of houses in millimetres.
bool HasEnds(const BBOX& box)
{
    const float leastOfEndless = BOUND_HUGE / 4;  // a half space has BOUND_HUGE / 2
    return box.Lengths[X] < leastOfEndless && box.Lengths[Y] < leastOfEndless && box.Lengths[Z] < leastOfEndless;
}

ObjectPtr Visible(ObjectPtr object)
{
    if (!(object->Type & LIGHT_SOURCE_OBJECT))
        return object;
    const std::vector<ObjectPtr>& children = static_cast<LightSource*>(object)->children;
    return children.empty() ? NULL : children[0];
}

struct Unflagged
{
    unsigned int flags;
    DBL least;

    bool Before(const Ray&, ObjectPtr object) const { return (object->Flags & flags) == 0; }
    bool After(const Ray&, ObjectPtr, DBL depth) const { return depth > least; }
};

struct TwoConditions
{
    const RayObjectCondition &before, &after;

    bool Before(const Ray& ray, ObjectPtr object) const { return before(ray, object, 0.0); }
    bool After(const Ray& ray, ObjectPtr object, DBL depth) const { return after(ray, object, depth); }
};

/// Find_Intersection() for an object whose box the ray met.
/// @param precedes  replaces the best at equal depth
/// @param hits      an empty stack; empty again afterwards
template<class Conditions>
TILT_LENS_INLINED bool FindNearer(ObjectPtr object, bool precedes, const Ray& ray, Intersection& best, const Conditions& conditions,
                                  IStack& hits, TraceThreadData* thread)
{
    if (!conditions.Before(ray, object))
        return false;
    if (!object->Bound.empty() && !Ray_In_Bound(ray, object->Bound, thread))
        return false;
    if (!object->All_Intersections(ray, hits, thread) || hits->empty())
        return false;
    const Intersection* nearest = NULL;
    DBL depth = best.Depth;
    const Intersection* hit = &hits->top();
    for (size_t left = hits->size(); left > 0; left--, hit--)
    {
        const bool nearer = hit->Depth < depth || (precedes && nearest == NULL && hit->Depth == depth);
        if (nearer && (ray.IsSubsurfaceRay() || hit->Depth >= MIN_ISECT_DEPTH) && conditions.After(ray, object, hit->Depth))
        {
            nearest = hit;
            depth = hit->Depth;
        }
    }
    if (nearest != NULL)
        best = *nearest;
    while (!hits->empty())
        hits->pop();
    return nearest != NULL;
}

/// MInvTransPoint() and MInvTransDirection() with the same operations.
TILT_LENS_INLINED void RayInFrame(const Ray& ray, const MATRIX& inverse, VECTOR origin, VECTOR direction)
{
    using tilt_lens::Double4;
    const Double4 x = tilt_lens::Load<Double4>(inverse[X]), y = tilt_lens::Load<Double4>(inverse[Y]);
    const Double4 z = tilt_lens::Load<Double4>(inverse[Z]), moved = tilt_lens::Load<Double4>(inverse[3]);
    const Double4 slope = ray.Direction[X] * x + ray.Direction[Y] * y + ray.Direction[Z] * z;
    const Double4 from = ray.Origin[X] * x + ray.Origin[Y] * y + ray.Origin[Z] * z + moved;
    for (int axis = X; axis <= Z; axis++)
    {
        origin[axis] = from[axis];
        direction[axis] = slope[axis];
    }
}

/// Same results as Mesh::intersect_mesh_triangle(), but rejects depths of `nearest` and beyond first.
TILT_LENS_INLINED bool MeetsTriangle(const MESH_DATA& data, const MESH_TRIANGLE& triangle, const VECTOR origin, const VECTOR direction,
                                     DBL nearest, DBL& depth)
{
    const DBL leastDepth = 1e-6;  // Mesh's DEPTH_TOLERANCE
    const SNGL_VECT& normal = data.Normals[triangle.Normal_Ind];
    DBL slope, height;
    VDot(slope, normal, direction);
    if (fabs(slope) < EPSILON)
        return false;
    VDot(height, normal, origin);
    depth = -(triangle.Distance + height) / slope;
    if (depth < leastDepth || depth > MAX_DISTANCE || !(depth < nearest))
        return false;

    const int u = triangle.Dominant_Axis == X ? Y : X, v = triangle.Dominant_Axis == Z ? Y : Z;
    const DBL s = origin[u] + depth * direction[u], t = origin[v] + depth * direction[v];
    const SNGL_VECT &corner1 = data.Vertices[triangle.P1], &corner2 = data.Vertices[triangle.P2], &corner3 = data.Vertices[triangle.P3];
    const DBL u1 = corner1[u], v1 = corner1[v], u2 = corner2[u], v2 = corner2[v];
    if ((u2 - s) * (v2 - v1) < (v2 - t) * (u2 - u1))
        return false;
    const DBL u3 = corner3[u], v3 = corner3[v];
    return !((u3 - s) * (v3 - v2) < (v3 - t) * (u3 - u2) || (u1 - s) * (v1 - v3) < (v1 - t) * (u1 - u3));
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
        if (HasEnds(object->BBox))
            items.push_back(ItemOf(object->BBox, &object));
        else
            infinite.push_back(&object);
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

template<class Vector, class Conditions>
TILT_LENS_INLINED bool SceneHierarchy::IntersectBy(const Ray& ray, Intersection& best, Conditions conditions, TraceThreadData* thread) const
{
    IStack hits(thread->stackPool);
    const ObjectPtr* holder = NULL;
    const auto test = [&](const ObjectPtr* object) __attribute__((always_inline))
    {
        if (FindNearer(*object, holder != NULL && object < holder, ray, best, conditions, hits, thread))
            holder = object;
    };
    for (const ObjectPtr* const object : infinite)
        test(object);
    Count(finite->Walk<Vector>(ray.Origin, ray.Direction, best.Depth, [&](const void* what) { test(static_cast<const ObjectPtr*>(what)); }),
          thread);
    return holder != NULL;
}

template<class Conditions>
bool SceneHierarchy::IntersectPlain(const Ray& ray, Intersection& best, Conditions conditions, TraceThreadData* thread) const
{
    return IntersectBy<Float4>(ray, best, conditions, thread);
}

template<class Conditions>
TILT_LENS_FOR_AVX2 bool SceneHierarchy::IntersectByAvx2(const Ray& ray, Intersection& best, Conditions conditions,
                                                        TraceThreadData* thread) const
{
    return IntersectBy<Float8>(ray, best, conditions, thread);
}

bool SceneHierarchy::Intersect(const Ray& ray, Intersection& best, unsigned int flags, DBL depth, TraceThreadData* thread) const
{
    const Unflagged unflagged = {flags, depth};
    return HasAvx2() ? IntersectByAvx2(ray, best, unflagged, thread) : IntersectPlain(ray, best, unflagged, thread);
}

bool SceneHierarchy::Intersect(const Ray& ray, Intersection& best, const RayObjectCondition& precondition,
                               const RayObjectCondition& postcondition, TraceThreadData* thread) const
{
    const TwoConditions both = {precondition, postcondition};
    return HasAvx2() ? IntersectByAvx2(ray, best, both, thread) : IntersectPlain(ray, best, both, thread);
}

bool MeshHierarchy::MakeTree(const Mesh& mesh)
{
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

template<class Vector>
TILT_LENS_INLINED bool MeshHierarchy::IntersectBy(Mesh& mesh, const Ray& ray, IStack& hits, TraceThreadData* thread)
{
    thread->Stats()[Ray_Mesh_Tests]++;
    VECTOR origin, direction;
    DBL length = 1.0;
    if (mesh.Trans != NULL)
    {
        RayInFrame(ray, mesh.Trans->inverse, origin, direction);
        VLength(length, direction);
        VInverseScaleEq(direction, length);
    }
    else
    {
        Assign_Vector(origin, ray.Origin);
        Assign_Vector(direction, ray.Direction);
    }
    DBL nearest = BOUND_HUGE;
    bool met = false;
    Count(mesh.Data->Hierarchy->Walk<Vector>(origin, direction, nearest,
                                             [&](const void* what)
    {
        const MESH_TRIANGLE* const triangle = static_cast<const MESH_TRIANGLE*>(what);
        DBL depth;
        if (!MeetsTriangle(*mesh.Data, *triangle, origin, direction, nearest, depth))
            return;
        const DBL worldDepth = depth / length;
        VECTOR point;
        VEvaluateRay(point, ray.Origin, worldDepth, ray.Direction);
        if (mesh.Clip.empty() || Point_In_Clip(point, mesh.Clip, thread))
        {
            hits->push(Intersection(worldDepth, point, &mesh, triangle));
            met = true;
            // a caller may reject nearer intersections; a mesh with an inside needs all of them
            if (!mesh.has_inside_vector && depth > SMALL_TOLERANCE * length)
                nearest = depth;
        }
    }),
          thread);
    if (met)
        thread->Stats()[Ray_Mesh_Tests_Succeeded]++;
    return met;
}

bool MeshHierarchy::IntersectPlain(Mesh& mesh, const Ray& ray, IStack& hits, TraceThreadData* thread)
{
    return IntersectBy<Float4>(mesh, ray, hits, thread);
}

bool MeshHierarchy::IntersectByAvx2(Mesh& mesh, const Ray& ray, IStack& hits, TraceThreadData* thread)
{
    return IntersectBy<Float8>(mesh, ray, hits, thread);
}

bool MeshHierarchy::AllIntersections(Mesh& mesh, const Ray& ray, IStack& hits, TraceThreadData* thread)
{
    return HasAvx2() ? IntersectByAvx2(mesh, ray, hits, thread) : IntersectPlain(mesh, ray, hits, thread);
}

} // namespace pov
