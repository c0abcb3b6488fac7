// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/render/send_layers.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/render/chief_camera_ray.h"
#include "backend/render/tracepixel.h"
#include "backend/scene/layer_attributes.h"
#include "backend/scene/tilt_lens_view.h"
#include "backend/scene/view.h"
#include "base/picture_layers.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

class LayerBlock
{
  public:
    explicit LayerBlock(size_t itsArea) : area(itsArea) {}

    size_t Add(const char* name)
    {
        names.push_back(name);
        values.resize(values.size() + area, 0.0f);
        return names.size() - 1;
    }

    POVMSFloat& At(size_t layer, size_t pixel) { return values[layer * area + pixel]; }

    void PutInto(POVMS_Message& message)
    {
        POVMS_Attribute numbers(values);
        message.SetString(kPOVAttrib_LayerNames, pov_base::JoinedNames(names).c_str());
        message.Set(kPOVAttrib_LayerValues, numbers);
    }

  private:
    const size_t area;
    std::vector<std::string> names;
    std::vector<POVMSFloat> values;
};

/// First hit, even on a transparent surface.
/// @param[out] point  world coordinates
/// @param[out] depth  along the camera's axis if it has one, else the ray's length
bool FirstPoint(TracePixel& trace, const ViewData& view, unsigned int x, unsigned int y, Vec3& point, DBL& depth)
{
    const Camera& camera = view.GetCamera();
    Ray ray;
    depth = MakeChiefRay(trace, ray, x, y, view.GetWidth(), view.GetHeight()) ? FirstHit(trace, camera, ray) : HUGE_VAL;
    if (!(depth < HUGE_VAL))
        return false;
    point = FromPov(ray.Origin) + depth * FromPov(ray.Direction);
    if (HasDepthAxis(camera))
        depth = Dot(point - FromPov(camera.Location), DepthAxis(camera));
    return true;
}

void Post(ViewData& view, POVMS_Message& message)
{
    message.SetInt(kPOVAttrib_ViewId, view.GetViewId());
    message.SetSourceAddress(view.GetSceneData()->backendAddress);
    message.SetDestinationAddress(view.GetSceneData()->frontendAddress);
    POVMS_SendMessage(message);
}

} // namespace

void SendLayers(TracePixel& trace, ViewData& view, const POVRect& rect, const std::vector<TiltLensEffort>& effort)
{
    if (!view.outputLayers)
        return;
    const TiltLensCamera& camera = view.GetCamera().TiltLens;
    const float infinity = std::numeric_limits<float>::infinity();
    const DBL width = view.GetWidth(), height = view.GetHeight();
    LayerBlock block(rect.GetArea());
    const size_t depthLayer = block.Add("depth.Z");
    const size_t positions[3] = {block.Add("position.X"), block.Add("position.Y"), block.Add("position.Z")};
    const size_t blur = camera.given ? block.Add("blur") : 0;
    const bool sampled = !effort.empty();
    const size_t samples = sampled ? block.Add("samples") : 0, error = sampled ? block.Add("standardError") : 0;

    size_t pixel = 0;
    for (unsigned int y = rect.top; y <= rect.bottom; y++)
        for (unsigned int x = rect.left; x <= rect.right; x++, pixel++)
        {
            Vec3 point;
            DBL depth = HUGE_VAL;
            const bool found = FirstPoint(trace, view, x, y, point, depth);
            block.At(depthLayer, pixel) = found ? float(depth) : infinity;
            block.At(positions[0], pixel) = point.x;
            block.At(positions[1], pixel) = point.y;
            block.At(positions[2], pixel) = point.z;
            if (view.GetTiltLens())
                block.At(blur, pixel) = view.GetTiltLens()->camera.lens->Blur(tilt_lens::FilmPointAt(x + 0.5, y + 0.5, width, height),
                                                                              found ? depth : double(infinity), width);
            if (sampled)
            {
                block.At(samples, pixel) = effort[pixel].samples;
                block.At(error, pixel) = std::sqrt(effort[pixel].variance);
            }
        }

    POVMS_Message message(kPOVObjectClass_PixelData, kPOVMsgClass_ViewImage, pov_base::kPOVMsgIdent_Layers);
    message.SetInt(kPOVAttrib_Left, rect.left);
    message.SetInt(kPOVAttrib_Top, rect.top);
    message.SetInt(kPOVAttrib_Right, rect.right);
    message.SetInt(kPOVAttrib_Bottom, rect.bottom);
    block.PutInto(message);
    Post(view, message);
}

void StartLayers(ViewData& view, POVMS_Object& options)
{
    view.outputLayers = options.TryGetBool(pov_base::kPOVAttrib_OutputLayers, false);
    if (!view.outputLayers)
        return;
    std::vector<std::string> names;
    std::vector<POVMSInt> sizes;
    std::vector<POVMSFloat> values;
    for (const LayerAttribute& attribute : LayerAttributesOf(view.GetCamera(), view.GetWidth()))
    {
        names.push_back(attribute.name);
        sizes.push_back(attribute.values.size());
        values.insert(values.end(), attribute.values.begin(), attribute.values.end());
    }
    if (names.empty())
        return;
    POVMS_Message message(kPOVObjectClass_PixelData, kPOVMsgClass_ViewImage, pov_base::kPOVMsgIdent_LayerAttributes);
    POVMS_Attribute numbers(values);
    message.SetString(pov_base::kPOVAttrib_LayerNames, pov_base::JoinedNames(names).c_str());
    message.SetIntVector(pov_base::kPOVAttrib_LayerSizes, sizes);
    message.Set(pov_base::kPOVAttrib_LayerValues, numbers);
    Post(view, message);
}

} // namespace pov
