// Loose bodies whose shape is a set of triangles, and what they meet: sim/contact between them.
//
// The manifold is looked for where the bodies will be at the end of the step, from their speeds,
// and set back to its start: what will touch is known before it does, as of the simple shapes.

#pragma once

#include <memory>

#include "geometry/mesh_contact/contact_mesh.h"
#include "geometry/mesh_contact/manifold.h"
#include "sim/world/solid.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// Triangles of a contact mesh that a scene may have.
inline constexpr std::size_t kMostContactTriangles = 20'000;

// Makes the body a homogeneous one of these triangles, its own axes the principal ones about its
// centre of mass.  start.pose is that of the centre of mass with the axes of the triangles, and is
// turned along.  Throws std::runtime_error for triangles that do not enclose a volume.
void give_mesh(const TriangleMesh& triangles, LooseBody& body);

// About its centre of mass, in its axes [kg m^2].
Eigen::Matrix3d inertia_of(const LooseBody& body) noexcept;

// Of a simple shape, round ones from outside.
std::shared_ptr<const ContactMesh> mesh_of(const Solid& solid);

// Of the box around a shape, or around its triangles if it has some [m^2].
double mean_face(const Solid& solid, const ContactMesh* mesh);

}  // namespace twinbus::sim
