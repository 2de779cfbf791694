// SPDX-License-Identifier: MIT
// The headers that most tests include, compiled once for all of them. A test includes what it uses
// all the same.

#include <gtest/gtest.h>

#include "base/precompiled.h"

#include <cstdio>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <thread>
