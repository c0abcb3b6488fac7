// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file scene_hierarchy.h
/// Bounding hierarchies of a scene's objects and of each mesh's triangles. At equal depth they find the scene's first object, as POV-Ray
/// does without bounding (-MB).

#ifndef SCENE_HIERARCHY_H
#define SCENE_HIERARCHY_H

#include <cmath>
#include <memory>
#include <vector>

#include "backend/frame.h"
#include "backend/shape/mesh.h"
#include "speedups/box_hierarchy.h"

namespace pov
{

class SceneHierarchy
{
  public:
    /// Includes meshes in CSG, bounding and clipping objects.
    /// @param all  must outlive the hierarchy
    explicit SceneHierarchy(const std::vector<ObjectPtr>& all);

    /// Call before Intersect().
    void AddObjects(const std::vector<ObjectPtr>& all);

    unsigned int FiniteObjects() const { return objects.size() - infinite.size(); }
    unsigned int InfiniteObjects() const { return infinite.size(); }

    /// False: none is nearer than `best`.
    bool Intersect(const Ray& ray, Intersection& best, TraceThreadData* thread) const { return Intersect(ray, best, 0, -HUGE_VAL, thread); }

    bool Intersect(const Ray& ray, Intersection& best, const RayObjectCondition& precondition, const RayObjectCondition& postcondition,
                   TraceThreadData* thread) const;

    /// Only objects without these flags, and intersections beyond the depth.
    bool Intersect(const Ray& ray, Intersection& best, unsigned int flags, DBL depth, TraceThreadData* thread) const;

  private:
    std::vector<std::unique_ptr<speedups::BoxHierarchy>> meshes;
    std::vector<ObjectPtr> objects;
    std::vector<const ObjectPtr*> infinite;
    std::unique_ptr<speedups::BoxHierarchy> finite;

    void AddMeshes(const std::vector<ObjectPtr>& among);
    void AddMeshes(ObjectPtr object);

    template<class Vector, class Conditions>
    bool IntersectBy(const Ray& ray, Intersection& best, Conditions conditions, TraceThreadData* thread) const;
    template<class Conditions>
    bool IntersectPlain(const Ray& ray, Intersection& best, Conditions conditions, TraceThreadData* thread) const;
    template<class Conditions>
    TILT_LENS_FOR_AVX2 bool IntersectByAvx2(const Ray& ray, Intersection& best, Conditions conditions, TraceThreadData* thread) const;
};

class MeshHierarchy
{
  public:
    /// The first call makes stock's tree, if the mesh is bounded. Thread-safe.
    static bool HasTree(const Mesh& mesh)
    {
        return __atomic_load_n(&mesh.Data->Tree, __ATOMIC_ACQUIRE) != NULL || (mesh.Data->Bounded && MakeTree(mesh));
    }

    static std::unique_ptr<speedups::BoxHierarchy> Of(Mesh& mesh);

    static bool AllIntersections(Mesh& mesh, const Ray& ray, IStack& hits, TraceThreadData* thread);

  private:
    static bool MakeTree(const Mesh& mesh);

    template<class Vector>
    static bool IntersectBy(Mesh& mesh, const Ray& ray, IStack& hits, TraceThreadData* thread);
    static bool IntersectPlain(Mesh& mesh, const Ray& ray, IStack& hits, TraceThreadData* thread);
    TILT_LENS_FOR_AVX2 static bool IntersectByAvx2(Mesh& mesh, const Ray& ray, IStack& hits, TraceThreadData* thread);
};

} // namespace pov

#endif
