#include "engine/boat/navigation.h"

#include <cmath>

#include "engine/core/angles.h"

namespace offing {

PointOfSail point_of_sail(double twa) {
  const double a = degrees(std::abs(twa));
  if (a < 30.0) return PointOfSail::kHeadToWind;
  if (a < 55.0) return PointOfSail::kCloseHauled;
  if (a < 80.0) return PointOfSail::kCloseReach;
  if (a < 100.0) return PointOfSail::kBeamReach;
  if (a < 160.0) return PointOfSail::kBroadReach;
  return PointOfSail::kRunning;
}

std::string_view name(PointOfSail point) {
  switch (point) {
    case PointOfSail::kHeadToWind:
      return "head to wind";
    case PointOfSail::kCloseHauled:
      return "close-hauled";
    case PointOfSail::kCloseReach:
      return "close reach";
    case PointOfSail::kBeamReach:
      return "beam reach";
    case PointOfSail::kBroadReach:
      return "broad reach";
    case PointOfSail::kRunning:
      return "running";
  }
  return "";
}

std::string_view name(Trouble trouble) {
  switch (trouble) {
    case Trouble::kNone:
      return "";
    case Trouble::kCapsized:
      return "capsized";
    case Trouble::kNoWind:
      return "no wind";
    case Trouble::kSailsDown:
      return "sails down";
    case Trouble::kInIrons:
      return "in irons";
    case Trouble::kGoingAstern:
      return "going astern";
    case Trouble::kAback:
      return "sails aback";
    case Trouble::kLuffing:
      return "luffing";
    case Trouble::kStalled:
      return "stalled";
    case Trouble::kOverpowered:
      return "overpowered";
  }
  return "";
}

std::string_view advice(Trouble trouble) {
  switch (trouble) {
    case Trouble::kNone:
      return "";
    case Trouble::kCapsized:
      return "She lies on her side: wait for her to come up, or reset.";
    case Trouble::kNoWind:
      return "There is no wind to sail by: hold G for the motor.";
    case Trouble::kSailsDown:
      return "Hoist the sails.";
    case Trouble::kInIrons:
      return "The bow points into the wind: hold the rudder to one side until the sails fill.";
    case Trouble::kGoingAstern:
      return "She moves backward: hold the rudder to one side until the bow swings and the sails "
             "fill.";
    case Trouble::kAback:
      return "The wind is on the wrong side of the sails: turn away from it.";
    case Trouble::kLuffing:
      return "The sails shake: pull the sheets in or turn from the wind.";
    case Trouble::kStalled:
      return "The sails are too far in: let the sheets out.";
    case Trouble::kOverpowered:
      return "Too much wind in the sails: ease the mainsheet or reef.";
  }
  return "";
}

}  // namespace offing
