#include "ui/measurement/mapping_memory.h"

#include <QCryptographicHash>
#include <QSettings>
#include <QString>

#include "sim/core/error.h"
#include "sim/io/json_document.h"

namespace rotorbench {

namespace {

QString settingsKey(const CsvPreview& preview) {
  const std::string columns = columnsKey(preview);
  const QByteArray hash =
      QCryptographicHash::hash(QByteArray(columns.data(), static_cast<qsizetype>(columns.size())),
                               QCryptographicHash::Sha256);
  return "measurement/mappings/" + QString::fromLatin1(hash.toHex().left(32));
}

}  // namespace

std::optional<ImportSettings> rememberedSettings(const CsvPreview& preview) {
  const QString text = QSettings().value(settingsKey(preview)).toString();
  if (text.isEmpty()) return {};
  try {
    ImportSettings settings;
    readDocument(schema::ref(settings), text.toStdString(), "settings");
    return settings;
  } catch (const InputError&) {
    return {};  // of another version: guessed anew
  }
}

void rememberSettings(const CsvPreview& preview, const ImportSettings& settings) {
  QSettings().setValue(settingsKey(preview),
                       QString::fromStdString(writeDocument(schema::ref(settings))));
}

}  // namespace rotorbench
