// What the mains and the scene-access file read from outside.
#pragma once

uniform usamplerBuffer sceneTexels;
uniform usamplerBuffer hullTexels;
uniform float hullReach;  // largest coordinate of what the hulls contain
uniform vec3 cameraOrigin;
uniform vec3 cameraCorner;
uniform vec3 cameraStepX;
uniform vec3 cameraStepY;
uniform vec3 cameraLensX;
uniform vec3 cameraLensY;
uniform vec3 environmentRadiance;
uniform float environmentTurn;
uniform int filmWidth;
uniform int tileX;  // the part of the film that is drawn: its first pixel and its size
uniform int tileY;
uniform int tileWidth;
uniform int tileHeight;
uniform int bounceLimit;
uniform int passCount;
uniform uint firstSampleIndex;
uniform uint seedValue;
