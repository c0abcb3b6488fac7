// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file scene_hierarchy.h
/// The bounding hierarchies of a scene with `tilt_lens`: one of its objects, and one of the triangles of each mesh. They take
/// the place of stock's for rays; the nearest intersection is the same. Of objects at exactly the same depth it is that of the
/// object which the scene names first, as without any hierarchy (-MB), while stock's show the one that their queue comes to
/// first. This is why scenes without `tilt_lens` stay with them.

#ifndef SCENE_HIERARCHY_H
#define SCENE_HIERARCHY_H

#include <cmath>
#include <memory>
#include <vector>

#include "backend/frame.h"
#include "backend/shape/mesh.h"
#include "tilt_lens/hierarchy/box_hierarchy.h"

namespace pov
{

class SceneHierarchy
{
  public:
    /// Gives all meshes among the objects, in CSG, in bounding and in clipping objects, a hierarchy of their own.
    /// @param all  the scene's objects, which outlive the hierarchy
    explicit SceneHierarchy(const std::vector<ObjectPtr>& all);

    /// Makes the hierarchy of the objects, without which no intersections are found.
    void AddObjects(const std::vector<ObjectPtr>& all);

    unsigned int FiniteObjects() const { return objects.size() - infinite.size(); }
    unsigned int InfiniteObjects() const { return infinite.size(); }

    /// @param best   intersections nearer than its depth are looked for; set to the nearest
    /// @return       whether there is one
    bool Intersect(const Ray& ray, Intersection& best, TraceThreadData* thread) const
    {
        return Intersect(ray, best, 0, -HUGE_VAL, thread);
    }

    /// The same among objects and intersections that fulfil the conditions.
    bool Intersect(const Ray& ray, Intersection& best, const RayObjectCondition& precondition,
                   const RayObjectCondition& postcondition, TraceThreadData* thread) const;

    /// The same among objects that have none of the flags, and intersections at greater depths than the given one.
    bool Intersect(const Ray& ray, Intersection& best, unsigned int flags, DBL depth, TraceThreadData* thread) const;

  private:
    std::vector<std::unique_ptr<tilt_lens::BoxHierarchy>> meshes;
    std::vector<ObjectPtr> objects;          ///< in the scene's order
    std::vector<const ObjectPtr*> infinite;  ///< of these, objects without a finite box
    std::unique_ptr<tilt_lens::BoxHierarchy> finite;

    void AddMeshes(const std::vector<ObjectPtr>& among);
    void AddMeshes(ObjectPtr object);

    // The way through the hierarchy, written once and compiled for each kind of processor.
    template<class Vector, class Conditions>
    bool IntersectBy(const Ray& ray, Intersection& best, Conditions conditions, TraceThreadData* thread) const;
    template<class Conditions>
    bool IntersectPlain(const Ray& ray, Intersection& best, Conditions conditions, TraceThreadData* thread) const;
    template<class Conditions>
    TILT_LENS_FOR_AVX2 bool IntersectByAvx2(const Ray& ray, Intersection& best, Conditions conditions, TraceThreadData* thread) const;
};

/// A mesh's own way through its hierarchy, beside Mesh::intersect_bbox_tree(), and when stock's tree is made for the latter.
class MeshHierarchy
{
  public:
    /// Whether the mesh has stock's bounding tree, mesh.Data->Tree. Makes it when it is first asked for, in whichever thread.
    static bool HasTree(const Mesh& mesh)
    {
        return __atomic_load_n(&mesh.Data->Tree, __ATOMIC_ACQUIRE) != NULL || (mesh.Data->Bounded && MakeTree(mesh));
    }

    static std::unique_ptr<tilt_lens::BoxHierarchy> Of(Mesh& mesh);

    /// In place of Mesh::All_Intersections() for a mesh that has a hierarchy.
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
