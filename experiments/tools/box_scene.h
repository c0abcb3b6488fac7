// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file box_scene.h
/// scenes/paper/box_objects.inc for another tracer, in centimetres.

#ifndef PAPER_BOX_SCENE_H
#define PAPER_BOX_SCENE_H

#include "double_gauss.h"

namespace paper
{

class BoxScene
{
  public:
    BoxScene();

    /// Linear RGB.
    Vector Seen(const Ray& ray) const;

    /// Infinite for the sky.
    double Distance(const Ray& ray) const;

  private:
    struct Hit
    {
        double distance;
        Vector normal;  ///< world
    };

    Vector Local(const Vector& v) const;
    Vector World(const Vector& v) const;
    Hit HitBox(const Ray& ray) const;
    Vector Lit(const Ray& ray, double distance, const Vector& normal, const Vector& pigment) const;

    Vector mSun;
    double mCosine, mSine;  ///< of the box's turn about y
};

} // namespace paper

#endif
