#pragma once

/// Solids from text: the component Scene, which needs toml++.

#include <Cutwater/Scene/ReadScene.hpp>
