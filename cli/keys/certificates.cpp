#include "cli/keys/certificates.hpp"

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/pkcs7.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <array>
#include <stdexcept>

namespace mrroc::cli {

namespace {

using Memory = std::unique_ptr<BIO, decltype(&BIO_free_all)>;

[[noreturn]] void refuse(const std::string& what) {
  std::array<char, 256> reason{};
  ERR_error_string_n(ERR_get_error(), reason.data(), reason.size());
  throw std::runtime_error(what + ": " + reason.data());
}

void require(bool done, const char* what) {
  if (!done) refuse(what);
}

Memory memory(const std::string& text = {}) {
  Memory bio(text.empty() ? BIO_new(BIO_s_mem()) : BIO_new_mem_buf(text.data(), static_cast<int>(text.size())),
             &BIO_free_all);
  require(bio != nullptr, "memory");
  return bio;
}

std::string text_of(BIO* bio) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(bio, &data);
  return {data, static_cast<std::size_t>(size)};
}

void add_extension(X509* certificate, X509* issuer, int kind, const char* value) {
  X509V3_CTX context;
  X509V3_set_ctx_nodb(&context);
  X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
  const std::unique_ptr<X509_EXTENSION, decltype(&X509_EXTENSION_free)> extension(
      X509V3_EXT_conf_nid(nullptr, &context, kind, value), &X509_EXTENSION_free);
  require(extension != nullptr && X509_add_ext(certificate, extension.get(), -1) == 1, "certificate extension");
}

void set_random_serial(X509* certificate) {
  std::array<unsigned char, 16> bytes{};
  require(RAND_bytes(bytes.data(), bytes.size()) == 1, "random number");
  bytes[0] &= 0x7f;  // positive
  const std::unique_ptr<BIGNUM, decltype(&BN_free)> number(BN_bin2bn(bytes.data(), bytes.size(), nullptr), &BN_free);
  require(number != nullptr && BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(certificate)) != nullptr,
          "serial number");
}

}  // namespace

PrivateKey new_private_key() {
  PrivateKey key(EVP_EC_gen("P-256"), &EVP_PKEY_free);
  require(key != nullptr, "private key");
  return key;
}

Certificate certify(const std::string& name, EVP_PKEY* key, CertificateUse use, X509* issuer, EVP_PKEY* issuer_key) {
  Certificate certificate(X509_new(), &X509_free);
  require(certificate != nullptr, "certificate");
  X509* const made = certificate.get();
  require(X509_set_version(made, X509_VERSION_3) == 1, "certificate version");
  set_random_serial(made);
  X509_NAME* subject = X509_get_subject_name(made);
  const auto* text = reinterpret_cast<const unsigned char*>(name.c_str());
  require(X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_ASC, text, -1, -1, 0) == 1, "certificate name");
  X509* const signer = issuer != nullptr ? issuer : made;
  require(X509_set_issuer_name(made, X509_get_subject_name(signer)) == 1, "certificate issuer");
  require(ASN1_TIME_set_string_X509(X509_getm_notBefore(made), "20000101000000Z") == 1 &&
              ASN1_TIME_set_string_X509(X509_getm_notAfter(made), "20991231000000Z") == 1,
          "certificate validity");
  require(X509_set_pubkey(made, key) == 1, "certificate key");
  const bool authority = use == CertificateUse::authority;
  add_extension(made, signer, NID_basic_constraints, authority ? "critical,CA:TRUE" : "critical,CA:FALSE");
  add_extension(made, signer, NID_key_usage,
                authority ? "critical,keyCertSign,digitalSignature" : "critical,digitalSignature");
  add_extension(made, signer, NID_subject_key_identifier, "hash");
  require(X509_sign(made, issuer_key, EVP_sha256()) > 0, "certificate signature");
  return certificate;
}

std::string to_pem(X509* certificate) {
  const Memory bio = memory();
  require(PEM_write_bio_X509(bio.get(), certificate) == 1, "certificate file");
  return text_of(bio.get());
}

std::string to_pem(EVP_PKEY* key) {
  const Memory bio = memory();
  require(PEM_write_bio_PrivateKey(bio.get(), key, nullptr, nullptr, 0, nullptr, nullptr) == 1, "key file");
  return text_of(bio.get());
}

std::string sign_document(const std::string& document, X509* signer, EVP_PKEY* key) {
  constexpr int kFlags = PKCS7_TEXT | PKCS7_DETACHED | PKCS7_STREAM;
  const Memory in = memory(document);
  const std::unique_ptr<PKCS7, decltype(&PKCS7_free)> signature(PKCS7_sign(signer, key, nullptr, in.get(), kFlags),
                                                                &PKCS7_free);
  require(signature != nullptr, "signature");
  const Memory out = memory();
  require(SMIME_write_PKCS7(out.get(), signature.get(), in.get(), kFlags) == 1, "signed document");
  return text_of(out.get());
}

}  // namespace mrroc::cli
