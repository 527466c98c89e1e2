#pragma once
// What has been answered so far, as a value. A draft is always enough for a model, however little has been answered.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mbcc::dialog {

enum class Dialog : std::uint8_t {
#define MBCC_DIALOG(name, letter, confirmed) name,
#include "dialog/dialogs.def"
};

/// What can be asked for.
enum class Item : std::uint8_t {
#define MBCC_ITEM(name, dialog, check, prefill, implied, help) name,
#include "dialog/dialogs.def"
};

/// The place of one answer in a draft.
struct Slot {
  Item item;
  std::size_t index = 0;  ///< of the particle or equation, from 0
  std::size_t axis = 0;   ///< of the component

  friend bool operator==(const Slot&, const Slot&) = default;
};

/// A vector as answered: a component for each axis, or, as a model may have it, one expression for all of them.
struct Quantity {
  bool whole = false;  ///< components[0] is the vector
  std::array<std::string, 3> components;

  friend bool operator==(const Quantity&, const Quantity&) = default;
};

struct Particle {
  std::string name;  ///< as the model declares it: "1", "bob"
  std::string mass;
  Quantity position, velocity, force;
};

/// Answers as they were typed; empty is not answered yet. There may be more particles and equations than the counts
/// say: what was typed before a count became smaller is not lost.
struct Draft {
  std::string path;       ///< of the model that will be written; not known before it has a name
  std::string base;       ///< text of the model that the dialog started from; empty for a new one
  std::string base_name;  ///< name of that model
  std::string name, dimension, particle_count, equation_count;
  std::vector<Particle> particles;
  std::vector<std::string> equations;
  std::string step, from, to;
};

std::string& answer(Draft& draft, Slot slot);
const std::string& answer(const Draft& draft, Slot slot);

/// The quantity that a component belongs to.
Quantity& quantity(Draft& draft, Slot slot);
const Quantity& quantity(const Draft& draft, Slot slot);

/// The number that `text` has, of digits alone; nothing for other texts.
std::optional<std::size_t> natural(const std::string& text);

std::size_t axes(const Draft& draft);       ///< 3 while the dimension is not known
std::size_t particles(const Draft& draft);  ///< 0 while their number is not known
std::size_t equations(const Draft& draft);

/// Makes room for as many particles and equations as the counts say; new particles get the next numbers.
void make_room(Draft& draft);

}  // namespace mbcc::dialog
