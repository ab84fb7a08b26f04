// Contact lines: where surfaces touch or go through each other, faces are cut, so that no patch lies half under a box
// or on both sides of a wall.
#pragma once

#include "aktina/base/warnings.h"
#include "aktina/radiosity/mesher/flat_face.h"

namespace aktina {

/// Surfaces nearer to each other touch, of the scene's diagonal: as far off them as rays start.
inline constexpr double kTouch = 2e-5;

/// A line on a face, in its plane and within its outline, along which another face touches or crosses it.
struct Contact {
  uint32_t face;  // of the list given
  Point3d a, b;   // m
};

/// Every line at least `shortest`, m, long; sorted by face. Those along a face's own edges are none.
/// @param touch  m, between surfaces that touch
/// @return nothing where more than some 50 million pairs of faces are near each other; `*too_many` says so
std::vector<Contact> find_contacts(const std::vector<FlatFace>& faces, double touch, double shortest, bool* too_many);

/// Cuts faces along lines on them. @param flat  flat_faces(faces); @param lines  sorted by face
void cut_along(SceneFaces& faces, const std::vector<FlatFace>& flat, const std::vector<Contact>& lines);

/// Cuts faces along their contacts. Lines shorter than a sixteenth of a patch are left out, and the shortest where
/// there are more of them than four times the patches that the surfaces' area makes: counted in `warnings`. Time: n log
/// n in the faces and contacts. @param patch_size  m
void cut_at_contacts(SceneFaces& faces, double patch_size, Warnings& warnings);

}  // namespace aktina
