// Tables compressed by gzip: read like any other, and refused in one sentence where they are
// damaged or far too much.
#include <zlib.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "sim/io/gzip.h"
#include "sim/logs/csv_import.h"

using namespace rotorbench;

namespace {

const QByteArray kLog = "time [s],thrust [N]\n0,1\n0.5,2\n";

/// One member of a gzip file, made by zlib.
QByteArray gzip(const QByteArray& content, int level = 9) {
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    qFatal("zlib");
  QByteArray packed(
      static_cast<qsizetype>(deflateBound(&stream, static_cast<uLong>(content.size()))), '\0');
  QByteArray copy = content;
  stream.next_in = reinterpret_cast<Bytef*>(copy.data());
  stream.avail_in = static_cast<uInt>(copy.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END) qFatal("zlib");
  packed.truncate(static_cast<qsizetype>(stream.total_out));
  deflateEnd(&stream);
  return packed;
}

QByteArray changed(QByteArray bytes, qsizetype at) {
  bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
  return bytes;
}

}  // namespace

class TestCompressedTables : public QObject {
  Q_OBJECT
 private slots:
  void reads_data();
  void reads();
  void fromAFile();
  void refused_data();
  void refused();
  void everyCutAndEveryDamagedByte();
};

void TestCompressedTables::reads_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addRow("one member") << gzip(kLog);
  QTest::addRow("stored") << gzip(kLog, 0);
  QTest::addRow("two members") << gzip(kLog.left(25)) + gzip(kLog.mid(25));
  QTest::addRow("zeros behind it") << gzip(kLog) + QByteArray(512, '\0');
}

void TestCompressedTables::reads() {
  QFETCH(QByteArray, bytes);
  const TextLines lines = TextLines::fromBytes(bytes.toStdString(), "a.csv.gz");
  const ImportResult result = importTable(lines, guessSettings(lines));
  QVERIFY(result.usable());
  QCOMPARE(result.table.columns, (std::vector<std::vector<double>>{{0, 0.5}, {1, 2}}));
}

void TestCompressedTables::fromAFile() {
  const QTemporaryDir folder;
  QFile file(folder.filePath("log.csv.gz"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(gzip(kLog));
  file.close();
  QCOMPARE(TextLines::fromFile(file.fileName().toStdString()).size(), std::size_t{3});
}

void TestCompressedTables::refused_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("message");
  QTest::addRow("cut off") << gzip(kLog).chopped(5)
                           << "a.csv.gz: the compressed file is cut off; must be the whole gzip "
                              "file";
  QTest::addRow("only the first bytes") << QByteArray("\x1F\x8B")
                                        << "a.csv.gz: the compressed file is cut off; must be the "
                                           "whole gzip file";
  QTest::addRow("another check sum")
      << changed(gzip(kLog), gzip(kLog).size() - 6)
      << "a.csv.gz: the compressed file is damaged; must be an unharmed gzip file";
  QTest::addRow("no gzip") << QByteArray("\x1F\x8B\x08\xFFgarbage garbage")
                           << "a.csv.gz: the compressed file is damaged; must be an unharmed gzip "
                              "file";
  // 65 MiB of zeros in less than 70 kB.
  const QByteArray bomb = gzip(QByteArray(65 << 20, '0'));
  QVERIFY(bomb.size() < 70000);
  QTest::addRow("too much") << bomb
                            << "a.csv.gz: the compressed file holds too much; must be at most 64 "
                               "MiB when unpacked";
  QTest::addRow("too much in many members")
      << gzip(QByteArray(22 << 20, '0')).repeated(3)
      << "a.csv.gz: the compressed file holds too much; must be at most 64 MiB when unpacked";
  QTest::addRow("packed twice") << gzip(gzip(kLog))
                                << "a.csv.gz: this file is compressed; must be unpacked first (a "
                                   "spreadsheet: saved as CSV)";
  QTest::addRow("empty") << gzip({}) << "a.csv.gz: the file is empty; must be a table of text";
}

void TestCompressedTables::refused() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, message);
  try {
    (void)TextLines::fromBytes(bytes.toStdString(), "a.csv.gz");
    QFAIL("must be refused");
  } catch (const InputError& error) {
    QCOMPARE(QString(error.what()), message);
  }
}

/// Whatever is cut off or changed: the same text, a sentence, or a text of its own; never a crash
/// or a hang.
void TestCompressedTables::everyCutAndEveryDamagedByte() {
  const QByteArray whole = gzip(kLog);
  int refusals = 0;
  for (qsizetype i = 2; i < whole.size(); ++i) {
    for (const QByteArray& bytes : {whole.left(i), changed(whole, i)}) {
      try {
        (void)unpackGzip(bytes.toStdString(), 1000, "a");
      } catch (const InputError&) {
        ++refusals;
      }
    }
  }
  QVERIFY(refusals > whole.size());
}

QTEST_APPLESS_MAIN(TestCompressedTables)
#include "test_compressed_tables.moc"
