#include "engine/clouds/cloud_parameters.h"

namespace offing {

void CloudParameters::describe(FieldTable& table) {
  table.group("clouds")
      .number("scale", scale, {0.25, 4.0}, "", "size of the clouds")
      .number("density_threshold", density_threshold, {-1.0, 1.0}, "",
              "moves the clouds' edge inward")
      .number("density", density, {0.0, 8.0}, "", "multiplies the clouds' extinction")
      .number("extinction", extinction, {0.001, 0.3}, "1/m", "of a dense cloud")
      .number("base", base, {150.0, 4000.0}, "m", "height of the lowest bases")
      .choice("container", container, {"shell", "box"}, "what contains the clouds")
      .number("box_size", box_size, {1.0, 200.0}, "km", "side of the box")
      .number("edge_fade", edge_fade, {0.05, 20.0}, "km",
              "clouds thin out this near the container's sides")
      .number("weight_connected", shape_weights[0], {0.0, 1.0}, "",
              "of the connected channel of the body's noise")
      .number("weight_coarse", shape_weights[1], {0.0, 1.0}, "", "of its coarse cells")
      .number("weight_middle", shape_weights[2], {0.0, 1.0}, "", "of its middle cells")
      .number("weight_fine", shape_weights[3], {0.0, 1.0}, "", "of its fine cells")
      .vector("detail_weights", detail_weights, {0.0, 1.0}, "",
              "of the channels of the edges' noise: coarse, middle, fine")
      .number("roughness", roughness, {0.0, 3.0}, "", "how far the body's noise reaches")
      .number("erosion", erosion, {0.0, 3.0}, "", "how far the edges' noise reaches")
      .number("curl", curl, {0.0, 4.0}, "", "how far the edges are drawn out")
      .integer("light_steps", light_steps, {0, 6}, "steps toward the light; 0: by quality")
      .number("step_scale", step_scale, {0.25, 4.0}, "", "multiplies the length of the steps")
      .number("sun_absorption", sun_absorption, {0.0, 4.0}, "", "of light on its way in")
      .number("cloud_absorption", cloud_absorption, {0.0, 4.0}, "", "of light on its way out")
      .number("darkness_floor", darkness_floor, {0.0, 1.0}, "",
              "least share of the sunlight anywhere in a cloud")
      .choice("phase", phase, {"droplets", "lobes"},
              "how droplets scatter: as they do, or in two lobes")
      .number("droplets", droplets_um, {5.0, 50.0}, "um", "diameter of the droplets")
      .number("forward_scattering", forward_scattering, {0.0, 0.98}, "", "g of the forward lobe")
      .number("back_scattering", back_scattering, {0.0, 0.98}, "", "-g of the backward lobe")
      .number("back_share", back_share, {0.0, 1.0}, "", "share of the backward lobe")
      .number("phase_weight", phase_weight, {0.0, 1.0}, "",
              "of the phase function against even scattering")
      .number("brightness", brightness, {0.0, 4.0}, "", "of the clouds")
      .number("powder", powder, {0.0, 1.0}, "",
              "darkens thin edges that are lit from behind the eye")
      .number("ambient", ambient, {0.0, 4.0}, "", "light from sky and sea")
      .number("direction_offset", direction_offset_deg, {-180.0, 180.0}, "deg",
              "of the clouds' way against the wind's")
      .number("speed_factor", speed_factor, {0.0, 20.0}, "",
              "of the clouds' speed against the wind's")
      .number("shear", shear, {-2.0, 2.0}, "m/m", "how far tops lean downwind")
      .number("evolution", evolution, {0.0, 50.0}, "", "how fast clouds come and go")
      .text(
          "weather_picture", weather_picture,
          "a picture of coverage, type, height and rain (red, green, blue, alpha) in place of the "
          "weather; empty: none",
          [](std::string_view) { return std::string(); });
  effects.describe(table);
}

}  // namespace offing
