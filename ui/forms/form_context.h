// What every editor of a form shares. Lives as long as the form that hands it out.
#pragma once

#include <QLocale>
#include <QStringList>
#include <functional>

#include "ui/forms/document_model.h"
#include "ui/forms/unit_preferences.h"

namespace rotorbench {

struct FormContext {
  DocumentModel* model = nullptr;
  UnitPreferences* units = nullptr;
  QLocale locale{};
  /// Names offered where a field holds channel names; may be empty.
  std::function<QStringList()> channelNames{};
  /// Whether there are ready components for the struct or variant at a path, and the picker for it;
  /// may be empty.
  std::function<bool(const QString& path)> hasComponents{};
  std::function<void(const QString& path)> pickComponent{};
  /// A flight of this document goes on: fields that act at once are marked.
  bool flying = false;
};

}  // namespace rotorbench
