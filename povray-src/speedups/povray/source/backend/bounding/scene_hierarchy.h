// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file scene_hierarchy.h
/// Bounding hierarchies of a scene with `tilt_lens`, in place of stock's: one of its objects, and one of the triangles of each mesh.
/// They find the same nearest intersection. Of objects at exactly the same depth, they find the one that comes first in the scene, as
/// POV-Ray does without bounding (-MB); stock's hierarchies find the first in their queue. Scenes without `tilt_lens` therefore keep
/// stock's.

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
    /// Gives each mesh a hierarchy, in CSG, bounding and clipping objects as well.
    /// @param all  the scene's objects; must outlive the hierarchy
    explicit SceneHierarchy(const std::vector<ObjectPtr>& all);

    /// Builds the hierarchy of the objects; must precede Intersect().
    void AddObjects(const std::vector<ObjectPtr>& all);

    unsigned int FiniteObjects() const { return objects.size() - infinite.size(); }
    unsigned int InfiniteObjects() const { return infinite.size(); }

    /// @param best  in: only nearer intersections count; out: the nearest
    /// @return      true if there is one
    bool Intersect(const Ray& ray, Intersection& best, TraceThreadData* thread) const { return Intersect(ray, best, 0, -HUGE_VAL, thread); }

    /// Only objects and intersections that fulfil the conditions.
    bool Intersect(const Ray& ray, Intersection& best, const RayObjectCondition& precondition, const RayObjectCondition& postcondition,
                   TraceThreadData* thread) const;

    /// Only objects with none of the flags, and intersections beyond the given depth.
    bool Intersect(const Ray& ray, Intersection& best, unsigned int flags, DBL depth, TraceThreadData* thread) const;

  private:
    std::vector<std::unique_ptr<speedups::BoxHierarchy>> meshes;
    std::vector<ObjectPtr> objects;          ///< in the scene's order
    std::vector<const ObjectPtr*> infinite;  ///< those without a finite box
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

/// Traversal of a mesh's own hierarchy, and the making of stock's tree for Mesh::intersect_bbox_tree().
class MeshHierarchy
{
  public:
    /// True if the mesh has stock's bounding tree, mesh.Data->Tree. Makes the tree at the first call; thread-safe.
    static bool HasTree(const Mesh& mesh)
    {
        return __atomic_load_n(&mesh.Data->Tree, __ATOMIC_ACQUIRE) != NULL || (mesh.Data->Bounded && MakeTree(mesh));
    }

    static std::unique_ptr<speedups::BoxHierarchy> Of(Mesh& mesh);

    /// Replaces Mesh::All_Intersections() for a mesh with a hierarchy.
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
