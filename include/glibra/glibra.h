#pragma once
// All of the library.

#include <glibra/compare.h>
#include <glibra/diagnostic.h>
#include <glibra/render.h>
#include <glibra/result.h>
#include <glibra/scene.h>
#include <glibra/version.h>
