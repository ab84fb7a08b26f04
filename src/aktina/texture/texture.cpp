#include "aktina/texture/texture.h"
