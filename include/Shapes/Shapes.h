// SPDX-License-Identifier: MIT
// The whole interface.
#pragma once

#include <Shapes/Aabb2D.h>
#include <Shapes/Arc.h>
#include <Shapes/Backend.h>
#include <Shapes/Circle.h>
#include <Shapes/Compound.h>
#include <Shapes/Contact.h>
#include <Shapes/DebugDraw.h>
#include <Shapes/DynamicCircle.h>
#include <Shapes/Effects.h>
#include <Shapes/Filter.h>
#include <Shapes/Limits.h>
#include <Shapes/Line.h>
#include <Shapes/LineSeg.h>
#include <Shapes/MotionLimits.h>
#include <Shapes/Point.h>
#include <Shapes/Polyline.h>
#include <Shapes/Questions.h>
#include <Shapes/SceneDesc.h>
#include <Shapes/Shape.h>
#include <Shapes/ShapeMath.h>
#include <Shapes/World.h>
