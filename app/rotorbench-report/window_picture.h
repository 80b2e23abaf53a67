// A picture of the real window at work: it opens the experiment, presses Run and waits like a
// person.
#pragma once

#include <filesystem>

namespace rotorbench {

/// Flies the experiment in the window and saves what the window then shows as PNG. Needs a
/// QApplication whose settings belong to nobody. Throws std::runtime_error if the run does not end
/// within a minute.
void saveWindowPicture(const std::filesystem::path& experiment,
                       const std::filesystem::path& picture);

}  // namespace rotorbench
