// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file oracle_case.h
/// A case of the oracle (JSON), and its optics by other formulas than the fork's.

#ifndef WITNESS_ORACLE_CASE_H
#define WITNESS_ORACLE_CASE_H

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "vector.h"

namespace witness
{

struct Transformation
{
    enum class Kind
    {
        Translate,
        Rotate,
        Scale
    };
    Kind kind = Kind::Translate;
    Vector amount;  ///< scene units; degrees; factors
};

enum class Focus
{
    Lens,       ///< tilt, swing and a point
    PlaneTurn,  ///< focus_tilt, focus_swing and a point
    Plane,      ///< normal and distance from the world's origin
    ThreePoints
};

/// World frame, scene units, degrees.
struct CameraGiven
{
    Vector location, lookAt;
    std::optional<double> angle;        ///< horizontal, degrees
    std::optional<double> focalLength;  ///< mm; exactly one of angle and focalLength
    std::optional<double> aperture;     ///< twice the lens diameter
    std::optional<double> fStop;        ///< exactly one of aperture and fStop
    double filmWidth = 36.0;            ///< mm
    double sceneUnit = 1000.0;          ///< mm
    Focus focus = Focus::Lens;
    double turnUp = 0.0, turnRight = 0.0;  ///< tilt and swing, of lens or plane
    Vector points[3];       ///< the first is the focal point
    Vector normal;          ///< normal of the plane, any length
    double distance = 0.0;  ///< distance along the unit normal
    double shiftRight = 0.0, shiftUp = 0.0;  ///< mm
    int blades = 0;                          ///< 0: round
    double bladesAngle = 0.0;                ///< degrees, counter-clockwise from the camera
    std::vector<Transformation> transformations;
};

struct OracleCase
{
    std::string name, scene;    ///< scene: file beside the case
    int width = 0, height = 0;  ///< pixels
    CameraGiven camera;
};

/// World frame, scene units.
struct CameraSolved
{
    Vector location;
    Vector direction, right, up;
    Vector focus;                 ///< plane of sharp focus: focus.(X - location) = 1
    Vector lensNormal;            ///< unit, away from the film
    Vector lensX, lensY;          ///< axes of the lens disc, radius long
    double focalLength = 0.0, filmDistance = 0.0;
};

/// @throws std::runtime_error missing, doubled or unknown item.
OracleCase ReadCase(const nlohmann::json& text);

/// @throws std::runtime_error no such picture.
CameraSolved SolveCase(const CameraGiven& given, double aspect);

} // namespace witness

#endif
