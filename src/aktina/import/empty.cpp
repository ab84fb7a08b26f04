// Keeps the room's target while it has no other file.
