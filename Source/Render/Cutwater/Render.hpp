#pragma once

/// Pictures: the component Render, which needs libpng.

#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/CutPlane.hpp>
#include <Cutwater/Render/Image.hpp>
#include <Cutwater/Render/PatchColors.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Render/Slice.hpp>
